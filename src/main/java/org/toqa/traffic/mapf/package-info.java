/** One shot: paths for all robots from their starts to their goals, planned before anyone moves. */
@NullMarked
package org.toqa.traffic.mapf;

import org.jspecify.annotations.NullMarked;
