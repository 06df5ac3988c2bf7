/** Checks plans of many robots by the rules alone, apart from the planners. */
@NullMarked
package org.toqa.traffic.check;

import org.jspecify.annotations.NullMarked;
