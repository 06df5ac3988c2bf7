/** A task's life as a pure state machine: (state, event) to (state, commands). */
@NullMarked
package org.toqa.mission;

import org.jspecify.annotations.NullMarked;
