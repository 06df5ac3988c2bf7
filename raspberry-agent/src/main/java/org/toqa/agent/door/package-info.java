/**
 * The daemon's door: who may come in, how they show who they are, and how a robot and a server are
 * paired. Everything here runs on the threads of the connections, never inside a tick.
 */
@NullMarked
package org.toqa.agent.door;

import org.jspecify.annotations.NullMarked;
