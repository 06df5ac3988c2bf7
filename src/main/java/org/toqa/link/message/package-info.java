/** The messages of the robot link, as both ends read and write them. */
@NullMarked
package org.toqa.link.message;

import org.jspecify.annotations.NullMarked;
