package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import org.toqa.grid.OccupancyGrid;

/**
 * Which cells are allocated to whom now. Read anew from the robots with {@link #refresh}; a cell of
 * two, as under robots that were put side by side, counts as allocated to each for the other.
 */
final class CellAllocations {
  private static final int NOBODY = 0;
  private static final int SEVERAL = -1;

  /** By cell: a robot's number, nobody or several. */
  private final int[] holders;

  private final Collection<TrafficRobot> robots;

  CellAllocations(OccupancyGrid grid, Collection<TrafficRobot> robots) {
    this.holders = new int[grid.width() * grid.height()];
    this.robots = robots;
  }

  void refresh() {
    Arrays.fill(holders, NOBODY);
    robots.forEach(robot -> robot.forEachAllocated(cells -> allocate(robot, cells)));
  }

  void allocate(TrafficRobot robot, CellSet cells) {
    cells.forEach(
        cell -> {
          int before = holders[cell];
          holders[cell] = before == NOBODY || before == robot.number ? robot.number : SEVERAL;
        });
  }

  /** The other robots to which some of the cells are allocated. */
  List<TrafficRobot> otherHolders(TrafficRobot robot, CellSet cells) {
    List<TrafficRobot> others = new ArrayList<>();
    cells.forEach(
        cell -> {
          int number = holders[cell];
          if (number == SEVERAL) {
            robots.stream()
                .filter(other -> other.allocatedCells().get(cell))
                .forEach(other -> addTo(others, robot, other));
          } else if (number != NOBODY && number != robot.number) {
            robots.stream()
                .filter(other -> other.number == number)
                .forEach(other -> addTo(others, robot, other));
          }
        });
    return others;
  }

  private static void addTo(List<TrafficRobot> others, TrafficRobot robot, TrafficRobot found) {
    if (found != robot && !others.contains(found)) {
      others.add(found);
    }
  }
}
