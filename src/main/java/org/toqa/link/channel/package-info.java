/** Lines over a connection of the robot link, for both of its ends and for leaders. */
@NullMarked
package org.toqa.link.channel;

import org.jspecify.annotations.NullMarked;
