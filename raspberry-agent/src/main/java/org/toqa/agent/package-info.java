/**
 * The daemon on a robot: the robot's end of the link, the drives that it is sent, driven segment by
 * segment, and a journal that outlives it.
 *
 * <p>One thread calls {@link org.toqa.agent.Daemon#tick} every 20 ms, and everything that decides
 * or moves happens inside; the threads of the connections only read and write lines. There is no
 * clock inside: the time is handed to each tick, and may be real or simulated.
 */
@NullMarked
package org.toqa.agent;

import org.jspecify.annotations.NullMarked;
