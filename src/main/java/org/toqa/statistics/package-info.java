/** Figures of many values. */
@NullMarked
package org.toqa.statistics;

import org.jspecify.annotations.NullMarked;
