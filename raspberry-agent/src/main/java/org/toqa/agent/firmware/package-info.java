/** The microcontroller under a daemon: its frames, and how they are carried there and back. */
@NullMarked
package org.toqa.agent.firmware;

import org.jspecify.annotations.NullMarked;
