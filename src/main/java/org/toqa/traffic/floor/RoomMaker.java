package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Where a robot is on another's only path and no plan for all could move it, as one that is too
 * large for the lanes, it is sent to the nearest place where it is on nobody's path.
 */
final class RoomMaker {
  private static final Duration MAKE_ROOM_AFTER = Duration.ofSeconds(2);

  private final SingleRobotPlanner singleRobotPlanner;

  RoomMaker(SingleRobotPlanner singleRobotPlanner) {
    this.singleRobotPlanner = singleRobotPlanner;
  }

  /**
   * Sends away who is on the only path of a robot that has waited long enough.
   *
   * @param robots all, by name
   * @param claimed what they have or will need
   */
  void makeRoomFor(
      TrafficRobot robot, Map<String, TrafficRobot> robots, ClaimedAreas claimed, Instant now) {
    Instant since = robot.waiting.since();
    if (since == null || since.plus(MAKE_ROOM_AFTER).isAfter(now)) {
      return;
    }
    TrafficRobot other = robotBlocking(robot, robots);
    if (other == null || !other.isMovable() || other.hasPrecedenceOver(robot)) {
      return;
    }
    robot.waiting.setWanted(
        singleRobotPlanner.pathAroundStaying(robot, robots.values()).orElse(List.of()).stream()
            .map(Section::area)
            .toList());
    List<SweptArea> wanted = robot.waiting.wanted();
    if (wanted.isEmpty()) {
      return;
    }
    Optional<List<Section>> out =
        singleRobotPlanner.pathOutOf(other, claimed.ofOthers(other), wanted);
    if (out.isPresent()) {
      other.freeUnreleased();
      other.continueOn(ReservedPath.independent(other.committedEnd(), out.get()));
      other.waiting.setSince(other.goal() == null ? null : now);
    }
  }

  /** One that has a path and cannot go on it, as to where a formation is, blocks that too. */
  private @Nullable TrafficRobot robotBlocking(
      TrafficRobot robot, Map<String, TrafficRobot> robots) {
    WaitReason reason = robot.waiting.noPathReason();
    if (reason == null || reason.robot() == null) {
      return null;
    }
    TrafficRobot other = robots.get(reason.robot());
    if (other == null) {
      return null;
    }
    boolean isStanding =
        switch (reason) {
          case WaitReason.RobotStanding _ -> other.drive.isOver();
          case WaitReason.RobotPassing _ -> robot.isFormation() && !other.drive.isDriving();
          default -> false;
        };
    return isStanding ? other : null;
  }
}
