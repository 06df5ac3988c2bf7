/**
 * The daemon on a robot: the robot's end of the link, the way it is told driven segment by segment,
 * and a journal that outlives it.
 *
 * <p>One thread calls {@link org.toqa.agent.Daemon#tick} every 20 ms, and everything that decides
 * or moves happens inside; the threads of the connections only carry lines to and fro. There is no
 * clock inside: a tick is told what time it is, so that a robot lives in real time or in a
 * simulated one.
 */
@NullMarked
package org.toqa.agent;

import org.jspecify.annotations.NullMarked;
