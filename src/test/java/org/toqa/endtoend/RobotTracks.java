package org.toqa.endtoend;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.toqa.geometry.Vec2;

/** Where the robots of a floor went, moment by moment, and which of them crossed. */
final class RobotTracks {
  private static final double CELL = 0.3; // metres
  private static final double STEP = 0.02; // metres; shorter ones have no direction

  /** Two tracks cross where their directions differ by more than this, in either order. */
  private static final double ALONG = Math.PI / 6;

  /** Where each robot was when it had last gone a step. */
  private final Map<String, Vec2> lastSteps = new HashMap<>();

  private final Map<List<Long>, List<Passage>> passages = new HashMap<>();
  private final Set<String> crossings = new TreeSet<>();

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

  /**
   * @param to where the robot is now, metres, map frame
   */
  void add(String robot, Vec2 to) {
    Vec2 from = lastSteps.computeIfAbsent(robot, name -> to);
    if (from.distanceTo(to) < STEP) {
      return;
    }
    lastSteps.put(robot, to);
    Passage passage = new Passage(robot, to.minus(from).angle());
    List<Passage> here = passages.computeIfAbsent(cell(to), cell -> new ArrayList<>());
    for (Passage other : here) {
      if (passage.crosses(other)) {
        crossings.add(String.join(" x ", new TreeSet<>(Set.of(robot, other.robot))));
      }
    }
    here.add(passage);
  }

  private static List<Long> cell(Vec2 at) {
    return List.of(Math.round(Math.floor(at.x() / CELL)), Math.round(Math.floor(at.y() / CELL)));
  }

  /** The pairs of robots that passed a cell in different directions, such as {@code r1 x r4}. */
  Set<String> crossings() {
    return crossings;
  }
}
