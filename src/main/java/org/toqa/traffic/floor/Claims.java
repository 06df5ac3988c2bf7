package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;

/** What is whose now, found by place. Read anew from the robots with {@link #refresh}. */
final class Claims {
  /** The side of the squares by which areas are found, metres. */
  private static final double SQUARE = 1;

  private final Collection<TrafficRobot> robots;
  private final Map<Square, List<Claim>> bySquare = new HashMap<>();

  private record Square(int column, int row) {}

  private record Claim(TrafficRobot robot, SweptArea area) {}

  Claims(Collection<TrafficRobot> robots) {
    this.robots = robots;
  }

  void refresh() {
    bySquare.clear();
    robots.forEach(robot -> robot.allocated().forEach(area -> add(robot, area)));
  }

  void add(TrafficRobot robot, SweptArea area) {
    forEachSquare(
        area,
        0,
        square ->
            bySquare.computeIfAbsent(square, s -> new ArrayList<>()).add(new Claim(robot, area)));
  }

  /**
   * The other robots to which a robot would come too near.
   *
   * @param standing what it covers where it sets out
   * @param area what it would cover
   */
  Set<TrafficRobot> tooNear(TrafficRobot robot, SweptArea standing, SweptArea area) {
    Set<TrafficRobot> others = new LinkedHashSet<>();
    forEachSquare(
        area,
        Clearance.BETWEEN_ROBOTS,
        square -> {
          for (Claim claim : bySquare.getOrDefault(square, List.of())) {
            if (claim.robot != robot
                && !others.contains(claim.robot)
                && !Clearance.isKept(standing, area, claim.area)) {
              others.add(claim.robot);
            }
          }
        });
    return others;
  }

  private static void forEachSquare(SweptArea area, double around, Consumer<Square> consumer) {
    int lastColumn = index(area.east() + around);
    int lastRow = index(area.north() + around);
    for (int column = index(area.west() - around); column <= lastColumn; column++) {
      for (int row = index(area.south() - around); row <= lastRow; row++) {
        consumer.accept(new Square(column, row));
      }
    }
  }

  private static int index(double metres) {
    return (int) Math.floor(metres / SQUARE);
  }
}
