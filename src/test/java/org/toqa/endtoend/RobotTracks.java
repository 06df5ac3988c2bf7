package org.toqa.endtoend;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import tools.jackson.databind.JsonNode;

/** Where the robots of a floor were, snapshot by snapshot, as the API tells it. */
final class RobotTracks {
  private static final double CELL = 0.3; // metres
  private static final double STEP = 0.02; // metres; shorter ones have no direction

  /** Two tracks cross where their directions differ by more than this, in either order. */
  private static final double ALONG = Math.PI / 6;

  private final Map<String, Disc> spots = new HashMap<>();

  /** Where each robot was when it had last gone a step. */
  private final Map<String, Disc> lastSteps = new HashMap<>();

  private final Map<List<Long>, List<Passage>> passages = new HashMap<>();
  private final Set<String> crossings = new TreeSet<>();
  private double smallestGap = Double.POSITIVE_INFINITY;

  /** Where a robot is: metres, map frame. */
  private record Disc(double x, double y, double radius) {
    double gap(Disc other) {
      return Math.hypot(x - other.x, y - other.y) - radius - other.radius;
    }

    List<Long> cell() {
      return List.of(Math.round(Math.floor(x / CELL)), Math.round(Math.floor(y / CELL)));
    }
  }

  /**
   * @param direction radians
   */
  private record Passage(String robot, double direction) {
    boolean crosses(Passage other) {
      // |sin| is the same for a track and its reverse
      return !robot.equals(other.robot)
          && Math.abs(Math.sin(direction - other.direction)) > Math.sin(ALONG);
    }
  }

  void add(JsonNode robots) {
    for (JsonNode robot : robots) {
      JsonNode pose = robot.get("pose");
      if (!pose.isNull()) {
        double radius = robot.get("footprint").asDouble() / 2;
        move(
            robot.get("name").asString(),
            new Disc(pose.get("x").asDouble(), pose.get("y").asDouble(), radius));
      }
    }
    List<Disc> now = new ArrayList<>(spots.values());
    for (int i = 0; i < now.size(); i++) {
      for (int j = 0; j < i; j++) {
        smallestGap = Math.min(smallestGap, now.get(i).gap(now.get(j)));
      }
    }
  }

  private void move(String robot, Disc to) {
    spots.put(robot, to);
    Disc from = lastSteps.computeIfAbsent(robot, name -> to);
    if (Math.hypot(to.x - from.x, to.y - from.y) < STEP) {
      return;
    }
    lastSteps.put(robot, to);
    Passage passage = new Passage(robot, Math.atan2(to.y - from.y, to.x - from.x));
    List<Passage> here = passages.computeIfAbsent(to.cell(), cell -> new ArrayList<>());
    for (Passage other : here) {
      if (passage.crosses(other)) {
        crossings.add(String.join(" x ", new TreeSet<>(Set.of(robot, other.robot))));
      }
    }
    here.add(passage);
  }

  /** The least that any two robots' edges were ever apart, metres; below 0 they have met. */
  double smallestGap() {
    return smallestGap;
  }

  /** The pairs of robots that passed a cell in different directions, such as {@code r1 x r4}. */
  Set<String> crossings() {
    return crossings;
  }
}
