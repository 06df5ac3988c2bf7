/** One shot: ways for all robots from their starts to their goals, planned before anyone moves. */
@NullMarked
package org.toqa.traffic.oneshot;

import org.jspecify.annotations.NullMarked;
