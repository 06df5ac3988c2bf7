package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Finds out why a robot has no way to its goal. */
final class WaitReasonFinder {
  private final FreeSpace freeSpace;
  private final SingleRobotPlanner singleRobotPlanner;

  WaitReasonFinder(FreeSpace freeSpace, SingleRobotPlanner singleRobotPlanner) {
    this.freeSpace = freeSpace;
    this.singleRobotPlanner = singleRobotPlanner;
  }

  /**
   * @param m which wants to go somewhere and has no way there
   */
  WaitReason reasonFor(TrafficRobot m, Collection<TrafficRobot> robots) {
    Vec2 goal = Objects.requireNonNull(m.goal);
    if (m.goalTakenBy != null) {
      return new WaitReason.GoalTaken(m.goalTakenBy, goal);
    }
    Optional<List<Section>> sections = singleRobotPlanner.pathAroundNotMovable(m, robots);
    if (sections.isPresent()) {
      return firstBlocking(m, sections.get(), robots).orElse(new WaitReason.NoPlan(goal));
    }
    List<TrafficRobot> notMovable = robots.stream().filter(o -> !o.movable).toList();
    return singleRobotPlanner
        .pathAlone(m)
        .flatMap(alone -> firstBlocking(m, alone, notMovable))
        .orElseGet(() -> reasonWithoutPath(m, goal));
  }

  private Optional<WaitReason> firstBlocking(
      TrafficRobot m, List<Section> sections, Collection<TrafficRobot> robots) {
    return sections.stream()
        .map(section -> blocking(m, section, robots))
        .filter(Objects::nonNull)
        .findFirst();
  }

  private WaitReason reasonWithoutPath(TrafficRobot m, Vec2 goal) {
    for (Vec2 point : singleRobotPlanner.pointsWithoutObstacles(m)) {
      int touched = SweptCells.at(freeSpace.grid(), point, m.radius).firstIn(freeSpace.obstacles());
      if (touched >= 0) {
        return new WaitReason.ObstacleOnPath(
            freeSpace.grid().centre(freeSpace.grid().cell(touched)));
      }
    }
    return new WaitReason.NoPath(goal, 2 * m.radius);
  }

  private @Nullable WaitReason blocking(
      TrafficRobot m, Section section, Collection<TrafficRobot> robots) {
    for (TrafficRobot other : robots) {
      BitSet claimed = new BitSet();
      other.addClaimedTo(claimed);
      int cell = other == m ? -1 : section.cells().firstIn(claimed);
      if (cell >= 0) {
        Vec2 where = freeSpace.grid().centre(freeSpace.grid().cell(cell));
        if (!other.movable) {
          return new WaitReason.RobotNotMovable(other.name, where);
        }
        return other.path == null
            ? new WaitReason.RobotStanding(other.name, where)
            : new WaitReason.RobotPassing(other.name, where);
      }
    }
    return null;
  }
}
