package org.toqa.traffic.floor;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** Finds out why a robot has no path to its goal. */
final class WaitReasonFinder {
  private final FreeSpace freeSpace;
  private final SingleRobotPlanner singleRobotPlanner;
  private final RightOfWay rightOfWay;
  private final LaneTurns turns;

  WaitReasonFinder(
      FreeSpace freeSpace,
      SingleRobotPlanner singleRobotPlanner,
      RightOfWay rightOfWay,
      LaneTurns turns) {
    this.freeSpace = freeSpace;
    this.singleRobotPlanner = singleRobotPlanner;
    this.rightOfWay = rightOfWay;
    this.turns = turns;
  }

  /**
   * @param robot which wants to go somewhere and has no path there
   * @param claimed what the robots have or will need
   */
  WaitReason reasonFor(TrafficRobot robot, Collection<TrafficRobot> robots, ClaimedAreas claimed) {
    Vec2 goal = Objects.requireNonNull(robot.goal());
    if (robot.waiting.goalTakenBy() != null) {
      return new WaitReason.GoalTaken(robot.waiting.goalTakenBy(), goal);
    }
    Optional<WaitReason> atGoal = robotAtGoal(robot, robots);
    if (atGoal.isPresent()) {
      return atGoal.get();
    }
    Optional<List<Section>> sections = singleRobotPlanner.pathAroundStaying(robot, robots);
    if (sections.isPresent()) {
      List<TrafficRobot> standing = robots.stream().filter(SingleRobotPlanner::stays).toList();
      return firstBlocking(robot, sections.get(), standing, claimed)
          .or(() -> firstBlocking(robot, sections.get(), robots, claimed))
          .orElse(new WaitReason.NoPlan(goal));
    }
    List<TrafficRobot> notMovable = robots.stream().filter(o -> !o.isMovable()).toList();
    return singleRobotPlanner
        .pathAlone(robot)
        .flatMap(alone -> firstBlocking(robot, alone, notMovable, claimed))
        .orElseGet(() -> reasonWithoutPath(robot, goal, robots, claimed));
  }

  private Optional<WaitReason> robotAtGoal(TrafficRobot robot, Collection<TrafficRobot> robots) {
    return turns
        .cameFirst(robot)
        .flatMap(first -> robots.stream().filter(other -> other.name.equals(first)).findFirst())
        .map(first -> new WaitReason.RobotAtGoal(first.name, first.pose().position()));
  }

  private Optional<WaitReason> firstBlocking(
      TrafficRobot robot,
      List<Section> sections,
      Collection<TrafficRobot> robots,
      ClaimedAreas claimed) {
    return IntStream.range(0, sections.size())
        .mapToObj(i -> blocking(robot, sections.get(i), cellAfter(sections, i), robots, claimed))
        .filter(Objects::nonNull)
        .findFirst();
  }

  /** Where the robot is in a cell again, on section {@code i} or behind it. */
  private static Vec2 cellAfter(List<Section> sections, int i) {
    return sections.stream()
        .skip(i)
        .filter(section -> !section.endsHalfway())
        .findFirst()
        .orElseGet(sections::getLast)
        .end()
        .position();
  }

  /**
   * Who is on the lanes that lead to its goal, as in an aisle hardly wider than itself: first who
   * does not leave by itself.
   */
  private static Optional<WaitReason> onLanes(
      List<SweptArea> way,
      TrafficRobot robot,
      Collection<TrafficRobot> robots,
      ClaimedAreas claimed) {
    SweptArea standing = robot.areaAt(robot.committedEnd());
    return robots.stream()
        .filter(other -> other != robot)
        .filter(
            other ->
                claimed.of(other).stream()
                    .anyMatch(
                        area -> way.stream().anyMatch(on -> !Clearance.isKept(standing, on, area))))
        .min(
            Comparator.<TrafficRobot, Boolean>comparing(
                    other -> other.isMovable() && !SingleRobotPlanner.stays(other))
                .thenComparing(other -> !other.drive.isOver()))
        .map(other -> reason(other, other.pose().position()));
  }

  private static WaitReason reason(TrafficRobot other, Vec2 where) {
    if (!other.isMovable()) {
      return new WaitReason.RobotNotMovable(other.name, where);
    }
    if (SingleRobotPlanner.stays(other) && other.isGoal(other.pose())) {
      return new WaitReason.RobotAtGoal(other.name, other.pose().position());
    }
    return other.drive.isOver()
        ? new WaitReason.RobotStanding(other.name, where)
        : new WaitReason.RobotPassing(other.name, where);
  }

  private WaitReason reasonWithoutPath(
      TrafficRobot robot, Vec2 goal, Collection<TrafficRobot> robots, ClaimedAreas claimed) {
    List<SweptArea> lanes = LaneWay.areas(freeSpace.seenBy(robot), robot);
    return onLanes(lanes, robot, robots, claimed)
        .orElseGet(() -> reasonOfMap(robot, goal, !lanes.isEmpty()));
  }

  private WaitReason reasonOfMap(TrafficRobot robot, Vec2 goal, boolean hasLanes) {
    for (Vec2 point : singleRobotPlanner.pointsWithoutObstacles(robot)) {
      int touched =
          SweptArea.at(point, robot.radius())
              .cells(freeSpace.grid(), 0)
              .firstIn(freeSpace.seenBy(robot).obstacles());
      if (touched >= 0) {
        return new WaitReason.ObstacleOnPath(
            freeSpace.grid().centre(freeSpace.grid().cell(touched)));
      }
    }
    if (hasLanes) {
      return new WaitReason.NoPlan(goal); // not yet
    }
    return singleRobotPlanner
        .pointAgainstDirection(robot)
        .<WaitReason>map(where -> new WaitReason.AgainstOneWay(goal, where))
        .orElseGet(() -> new WaitReason.NoPath(goal, 2 * robot.radius()));
  }

  private @Nullable WaitReason blocking(
      TrafficRobot robot,
      Section section,
      Vec2 where,
      Collection<TrafficRobot> robots,
      ClaimedAreas claimed) {
    SweptArea standing = robot.areaAt(robot.committedEnd());
    for (TrafficRobot other : robots) {
      if (other != robot && claimed.isTooNear(other, standing, section.area())) {
        return reason(other, where);
      }
    }
    String first = rightOfWay.holder();
    return first != null
            && rightOfWay.closedTo(robot).stream()
                .anyMatch(area -> !Clearance.isKept(standing, section.area(), area))
        ? new WaitReason.RobotPassing(first, where)
        : null;
  }
}
