/** Motion as curve segments (v, w, t), the fitter from a path to segments, and wheel kinematics. */
@NullMarked
package org.toqa.motion;

import org.jspecify.annotations.NullMarked;
