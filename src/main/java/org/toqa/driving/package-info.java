/**
 * How a robot with two wheels drives a curve: the law that keeps it there, its speeds, and detours
 * round discs that move.
 */
@NullMarked
package org.toqa.driving;

import org.jspecify.annotations.NullMarked;
