/**
 * Who may connect to the daemon, how both ends show who they are, and how a robot and a server are
 * paired. Everything here runs on the threads of the connections, never inside a tick.
 */
@NullMarked
package org.toqa.agent.access;

import org.jspecify.annotations.NullMarked;
