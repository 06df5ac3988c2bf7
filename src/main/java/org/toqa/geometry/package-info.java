/** Poses, velocities and angles: plain values in SI units, angles counter-clockwise. */
@NullMarked
package org.toqa.geometry;

import org.jspecify.annotations.NullMarked;
