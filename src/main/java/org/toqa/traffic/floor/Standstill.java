package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.List;
import org.toqa.grid.Cell;

/**
 * What must not be and was seen all the same: robots that do not get on.
 *
 * @param robots by name; of a cycle in the order in which each waits for the next
 * @param cells where they are
 * @param since when it was first seen
 */
public record Standstill(Kind kind, List<String> robots, List<Cell> cells, Instant since) {

  public enum Kind {
    /** Each of the robots waits for the next, and the last for the first. */
    CYCLE_OF_WAITS,
    /** The robot may drive and has not got on for much longer than its path says. */
    NOT_MOVING
  }

  public Standstill {
    robots = List.copyOf(robots);
    cells = List.copyOf(cells);
  }
}
