package org.toqa.allocation;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A robot's part of a floor, by which {@link ZoneAllocator} decides: a strip across its longer
 * side.
 *
 * @param low corner, metres, map frame
 * @param high corner, metres, map frame
 */
public record Zone(String robot, Vec2 low, Vec2 high) {

  /**
   * Those of a floor, in their order.
   *
   * @param low corner of the floor, metres, map frame
   * @param high corner of the floor, metres, map frame
   * @param robots all of the floor
   */
  public static List<Zone> of(Vec2 low, Vec2 high, List<Candidate> robots) {
    return robots.isEmpty() ? List.of() : new Zones(low, high, robots).strips();
  }
}
