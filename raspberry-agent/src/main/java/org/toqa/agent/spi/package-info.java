/** The microcontroller under a daemon: its frames, and the ways they are carried there and back. */
@NullMarked
package org.toqa.agent.spi;

import org.jspecify.annotations.NullMarked;
