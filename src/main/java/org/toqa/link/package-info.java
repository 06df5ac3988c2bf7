/** The server's end of the robot link. */
@NullMarked
package org.toqa.link;

import org.jspecify.annotations.NullMarked;
