/** The experiments of CMCT: its path planner, and its supervisor with two workers. */
@NullMarked
package org.toqa.lab.cmct;

import org.jspecify.annotations.NullMarked;
