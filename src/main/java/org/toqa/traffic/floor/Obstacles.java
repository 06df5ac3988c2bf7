package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.Map;

/**
 * What is on the floor where the map shows nothing, and for whom some of it does not count: a load
 * does not for who fetches it or stands in it already. Nobody changes the sets.
 *
 * @param cells all that are obstructed, as bits by {@link org.toqa.grid.OccupancyGrid#index}
 * @param passable by robot, those of the cells that do not count for it
 */
record Obstacles(BitSet cells, Map<String, BitSet> passable) {
  private static final BitSet NO_CELLS = new BitSet();
  static final Obstacles NONE = new Obstacles(NO_CELLS, Map.of());

  Obstacles {
    passable = Map.copyOf(passable);
  }

  boolean allCountFor(String robot) {
    return !cells.intersects(passableFor(robot));
  }

  /** Those that count for the robot. */
  BitSet of(String robot) {
    if (allCountFor(robot)) {
      return cells;
    }
    BitSet counting = (BitSet) cells.clone();
    counting.andNot(passableFor(robot));
    return counting;
  }

  private BitSet passableFor(String robot) {
    return passable.getOrDefault(robot, NO_CELLS);
  }
}
