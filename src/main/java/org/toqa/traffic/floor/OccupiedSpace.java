package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.List;
import org.toqa.grid.OccupancyGrid;

/** Where robots that are planned together cannot be. */
final class OccupiedSpace {
  private final OccupancyGrid grid;
  private final BitSet blocked;
  private final AreaIndex claimed;

  /**
   * @param blocked the cells of walls and obstacles
   * @param claimed what robots that are not planned with them have or will need
   */
  OccupiedSpace(OccupancyGrid grid, BitSet blocked, List<SweptArea> claimed) {
    this.grid = grid;
    this.blocked = blocked;
    this.claimed = new AreaIndex(claimed);
  }

  /** The cells of walls and obstacles; not to be changed. */
  BitSet blocked() {
    return blocked;
  }

  /** What robots that are not planned with them have or will need. */
  AreaIndex claimed() {
    return claimed;
  }

  /**
   * Whether a robot can go over an area.
   *
   * @param standing what it covers where it sets out
   */
  boolean isFree(SweptArea standing, SweptArea area) {
    return !area.cells(grid, 0).intersects(blocked) && claimed.isKept(standing, area);
  }

  /** Whether a robot can drive a section. */
  boolean isFree(SweptArea standing, Section section) {
    return !section.cells().intersects(blocked) && claimed.isKept(standing, section.area());
  }
}
