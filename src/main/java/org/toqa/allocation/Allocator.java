package org.toqa.allocation;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * Decides which robots carry a load.
 *
 * <ol>
 *   <li>The caller names the load and every robot of the floor, free or not.
 *   <li>{@link #allocate} answers the robots, or what the task waits for. It is a function of its
 *       arguments.
 *   <li>A task that waits is asked about again whenever a robot's availability changes.
 * </ol>
 *
 * Any thread may call it.
 */
public interface Allocator {

  /**
   * @param load kilograms
   * @param object where the load is, metres, map frame
   */
  Decision allocate(double load, Vec2 object, List<Candidate> robots);
}
