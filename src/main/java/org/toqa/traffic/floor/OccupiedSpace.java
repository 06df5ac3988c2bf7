package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.List;
import org.toqa.grid.OccupancyGrid;

/**
 * Where robots that are planned together cannot be.
 *
 * @param blocked the cells of walls and obstacles
 * @param claimed what robots that are not planned with them have or will need
 */
record OccupiedSpace(OccupancyGrid grid, BitSet blocked, List<SweptArea> claimed) {

  /**
   * Whether a robot can go over an area.
   *
   * @param standing what it covers where it sets out
   */
  boolean isFree(SweptArea standing, SweptArea area) {
    return !area.cells(grid, 0).intersects(blocked) && isOffClaimed(standing, area);
  }

  /** Whether a robot can drive a section. */
  boolean isFree(SweptArea standing, Section section) {
    return !section.cells().intersects(blocked) && isOffClaimed(standing, section.area());
  }

  private boolean isOffClaimed(SweptArea standing, SweptArea area) {
    return claimed.stream().allMatch(other -> Clearance.isKept(standing, area, other));
  }
}
