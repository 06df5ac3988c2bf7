/** The connections of a daemon: of its server, and of a leader that it follows. */
@NullMarked
package org.toqa.agent.connection;

import org.jspecify.annotations.NullMarked;
