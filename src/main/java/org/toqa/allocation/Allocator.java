package org.toqa.allocation;

import java.util.List;

/**
 * Decides which robots carry what.
 *
 * <ol>
 *   <li>The caller hands in the whole {@link AllocationProblem} of a floor: what waits, what is
 *       given out but not begun, and every robot, free or not. The time is part of it.
 *   <li>{@link #allocate} holds one round over all of it. It is a function of its argument.
 *   <li>It answers a decision with its reason for each waiting task, and one for each task given
 *       out that shall go to another robot. No robot is in two of them.
 *   <li>The next round is due when tasks come, or robots become free or are lost.
 * </ol>
 *
 * A load that no robot can carry alone waits, with the number of robots that it needs. Any thread
 * may call it; a round with many tasks takes its time.
 */
public interface Allocator {

  List<Decision> allocate(AllocationProblem problem);
}
