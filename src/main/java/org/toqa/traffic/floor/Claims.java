package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.toqa.grid.OccupancyGrid;

/**
 * What is whose now, found by place. {@link #refresh} reads again what robots have whose place or
 * path has changed; what is asked costs as much as there is near to it, however many robots the
 * floor has.
 */
final class Claims {
  private final Collection<TrafficRobot> robots;
  private final Map<TrafficRobot, Entry> byRobot = new HashMap<>();
  private final Map<Square, List<Claim>> bySquare = new HashMap<>();
  private long readings;
  private long comparisons;

  private record Claim(TrafficRobot robot, SweptArea area) {}

  /** A robot's areas, as they were when it had changed so many times. */
  private record Entry(long changes, List<SweptArea> areas) {}

  Claims(Collection<TrafficRobot> robots) {
    this.robots = robots;
  }

  void refresh() {
    for (TrafficRobot robot : robots) {
      Entry known = byRobot.get(robot);
      if (known == null || known.changes != robot.changes()) {
        readings++;
        replace(robot, known == null ? List.of() : known.areas);
      }
    }
  }

  /** Most of what a robot has stays the same while it drives: that is left where it is. */
  private void replace(TrafficRobot robot, List<SweptArea> former) {
    List<SweptArea> now = robot.allocated();
    for (SweptArea area : former) {
      if (!isAmong(area, now)) {
        remove(robot, area);
      }
    }
    for (SweptArea area : now) {
      if (!isAmong(area, former)) {
        put(robot, area);
      }
    }
    byRobot.put(robot, new Entry(robot.changes(), now));
  }

  @SuppressWarnings("ReferenceEquality") // sections keep their areas, and these are compared often
  private static boolean isAmong(SweptArea area, List<SweptArea> areas) {
    for (int i = 0; i < areas.size(); i++) { // without an iterator each time
      if (areas.get(i) == area) {
        return true;
      }
    }
    return false;
  }

  /** The robot has that too, until it is read again. */
  void add(TrafficRobot robot, SweptArea area) {
    Entry entry = byRobot.get(robot);
    if (entry == null) {
      throw new IllegalArgumentException(robot.name + " is not known.");
    }
    entry.areas.add(area);
    put(robot, area);
  }

  /** The robot has nothing any more. */
  void remove(TrafficRobot robot) {
    Entry entry = byRobot.remove(robot);
    if (entry != null) {
      entry.areas.forEach(area -> remove(robot, area));
    }
  }

  private void put(TrafficRobot robot, SweptArea area) {
    Claim claim = new Claim(robot, area);
    Square.forEach(
        area, 0, square -> bySquare.computeIfAbsent(square, s -> new ArrayList<>()).add(claim));
  }

  private void remove(TrafficRobot robot, SweptArea area) {
    Square.forEach(area, 0, square -> removeFrom(square, robot, area));
  }

  @SuppressWarnings("ReferenceEquality") // it is the one that was put there
  private void removeFrom(Square square, TrafficRobot robot, SweptArea area) {
    List<Claim> there = bySquare.get(square);
    if (there != null) {
      there.removeIf(claim -> claim.robot == robot && claim.area == area);
      if (there.isEmpty()) {
        bySquare.remove(square);
      }
    }
  }

  /**
   * The other robots to which a robot would come too near.
   *
   * @param standing what it covers where it sets out
   * @param area what it would cover
   */
  Set<TrafficRobot> tooNear(TrafficRobot robot, SweptArea standing, SweptArea area) {
    Set<TrafficRobot> others = new LinkedHashSet<>();
    Square.forEach(
        area,
        Clearance.BETWEEN_ROBOTS,
        square -> {
          for (Claim claim : bySquare.getOrDefault(square, List.of())) {
            comparisons++;
            if (claim.robot != robot
                && !others.contains(claim.robot)
                && !Clearance.isKept(standing, area, claim.area)) {
              others.add(claim.robot);
            }
          }
        });
    return others;
  }

  /** The robots of whose areas one touches a cell. */
  Set<TrafficRobot> at(OccupancyGrid grid, int cell) {
    Set<TrafficRobot> found = new LinkedHashSet<>();
    double half = grid.resolution() / 2;
    SweptArea whole = SweptArea.at(grid.centre(grid.cell(cell)), half);
    Square.forEach(
        whole,
        0,
        square -> {
          for (Claim claim : bySquare.getOrDefault(square, List.of())) {
            comparisons++;
            if (!found.contains(claim.robot) && claim.area.cells(grid, 0).contains(cell)) {
              found.add(claim.robot);
            }
          }
        });
    return found;
  }

  /** How often a robot's areas were read, since the beginning. */
  long readings() {
    return readings;
  }

  /** How many areas were looked at to answer what was asked, since the beginning. */
  long comparisons() {
    return comparisons;
  }
}
