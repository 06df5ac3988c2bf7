/** Makes curves that a robot can drive of paths of straight lines, and checks them exactly. */
@NullMarked
package org.toqa.planning.smooth.curve;

import org.jspecify.annotations.NullMarked;
