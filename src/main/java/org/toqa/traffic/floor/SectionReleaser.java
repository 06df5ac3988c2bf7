package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.traffic.floor.ReservedPath.Dependency;

/**
 * Lets robots go on: a section is released when nothing that is another robot's is too near to it
 * and whoever comes before has left.
 */
final class SectionReleaser {
  private static final Duration SPLIT_CORNER_AFTER = Duration.ofMillis(500);

  /** Released ahead of a robot: at least so many seconds of driving. */
  private static final double SECONDS_AHEAD = 3;

  /** The same of one that a plan is being made for, which had more when that began. */
  private static final double SECONDS_AHEAD_WHILE_PLANNED = 2;

  private final SectionFitter fitter;
  private final Map<String, TrafficRobot> robots;
  private final Claims claims;
  private final ReplanTrigger trigger;

  SectionReleaser(
      SectionFitter fitter,
      Map<String, TrafficRobot> robots,
      Claims claims,
      ReplanTrigger trigger) {
    this.fitter = fitter;
    this.robots = robots;
    this.claims = claims;
    this.trigger = trigger;
  }

  /**
   * @param isPlanned whether a plan is being made that goes on where its released part ends: if
   *     that can stay there, it does
   * @param until so many sections of its path and no more
   */
  void release(TrafficRobot robot, boolean isPlanned, int until, Instant now) {
    ReservedPath path = robot.drive.path();
    if (path == null || !robot.isMovable() || robot.isStalled()) {
      return;
    }
    double enough = isPlanned ? SECONDS_AHEAD_WHILE_PLANNED : SECONDS_AHEAD;
    while (robot.drive.released() < Math.min(path.sectionCount(), until)
        && Allocation.secondsAhead(robot) < enough) {
      if (!canEnter(robot, path, robot.drive.released())) {
        if (isBarredHalfway(robot, now)) {
          freeCommitted(robot);
          return;
        }
        if (!hasWaited(robot, now) || !splitCorner(robot, path)) {
          return;
        }
        path = Objects.requireNonNull(robot.drive.path());
        continue;
      }
      claims.add(robot, path.sections().get(robot.drive.released()).area());
      robot.drive.releaseNext(now);
      robot.waiting.unblock();
    }
  }

  /**
   * Releases all sections that are needed up to a segment, or none.
   *
   * @param segments of the path, counted from its first
   */
  boolean releaseUntil(TrafficRobot robot, int segments, Instant now) {
    ReservedPath path = robot.drive.path();
    if (path == null) {
      return false;
    }
    int end = robot.drive.released();
    while (path.segmentCount(end) < segments) {
      if (!canEnter(robot, path, end)) {
        return false;
      }
      end++;
    }
    while (robot.drive.released() < end) {
      claims.add(robot, path.sections().get(robot.drive.released()).area());
      robot.drive.releaseNext(now);
      robot.waiting.unblock();
    }
    return true;
  }

  private boolean canEnter(TrafficRobot robot, ReservedPath path, int index) {
    Section section = path.sections().get(index);
    Vec2 where = path.poseAfter(path.committed(index + 1)).position();
    SweptArea standing = robot.areaAt(path.poseAfter(index));
    for (TrafficRobot other : claims.tooNear(robot, standing, section.area())) {
      robot.waiting.setBlockedReason(new WaitReason.RobotPassing(other.name, where));
      return false;
    }
    if (index < path.inherited() || !path.isShared()) {
      return true;
    }
    int last = path.visitAfterSections(path.committed(index + 1));
    for (int v = path.visitAfterSections(index) + 1; v <= last; v++) {
      for (Dependency dependency : path.dependencies().get(v)) {
        if (!isOver(dependency)) {
          robot.waiting.setBlockedReason(new WaitReason.RobotPassing(dependency.robot(), where));
          return false;
        }
      }
    }
    return true;
  }

  /** Whether the other may go on from there: claims keep who comes behind it at a distance. */
  private boolean isOver(Dependency dependency) {
    TrafficRobot other = robots.get(dependency.robot());
    return other == null
        || other.drive.pathNumber() != dependency.pathNumber()
        || other.drive.path() == null
        || other.drive.path().visitAfterSections(other.drive.committed()) > dependency.visit();
  }

  /**
   * Whether it was stopped between two cells by one that cannot go on, or by one that was stopped
   * there by it: then it is not bound to go on to the next cell, but planned from where it is.
   */
  private boolean isBarredHalfway(TrafficRobot robot, Instant now) {
    if (!isHalfway(robot) || !hasWaited(robot, now)) {
      return false;
    }
    TrafficRobot other = blocking(robot);
    return other != null && (stays(other) || isInCycleHalfway(robot));
  }

  private boolean isInCycleHalfway(TrafficRobot robot) {
    Set<TrafficRobot> seen = new HashSet<>();
    TrafficRobot at = robot;
    while (at != null && isHalfway(at) && !at.drive.isDriving() && seen.add(at)) {
      at = blocking(at);
    }
    return at == robot;
  }

  private static boolean isHalfway(TrafficRobot robot) {
    return robot.drive.released() < robot.drive.committed();
  }

  private @Nullable TrafficRobot blocking(TrafficRobot robot) {
    WaitReason reason = robot.waiting.blockedReason();
    return reason == null || reason.robot() == null ? null : robots.get(reason.robot());
  }

  private static boolean stays(TrafficRobot robot) {
    return robot.isStalled() || (!robot.isMovable() && !robot.drive.isDriving());
  }

  private void freeCommitted(TrafficRobot robot) {
    trigger.markFreed(robot);
    trigger.markChanged();
    robot.freeUnreleased();
    robot.waiting.restartBlocked();
  }

  /** Whether it has been stopped before the section for a little. */
  private static boolean hasWaited(TrafficRobot robot, Instant now) {
    if (robot.drive.completed() < robot.drive.released()) {
      return false;
    }
    return robot.waiting.blockedSince(now).plus(SPLIT_CORNER_AFTER).isBefore(now);
  }

  /**
   * A corner that is rounded needs the cells before and behind it at once; a robot that has waited
   * for both drives up to the corner, turns there on the spot, and so needs one at a time.
   */
  private boolean splitCorner(TrafficRobot robot, ReservedPath path) {
    int index = robot.drive.released();
    LanePoints lanes = path.lanes();
    if (lanes == null || index < path.inherited() || index < path.committed(index)) {
      return false;
    }
    int from = path.visitAfterSections(index);
    int until = path.visitAfterSections(path.committed(index + 1));
    if (until - from < 2) {
      return false;
    }
    List<Cell> visits = path.visits();
    Pose pose = path.poseAfter(index);
    List<Waypoint> waypoints =
        JointPlan.waypointsFromCentre(
            lanes, visits, from, lanes.goalPoint(robot), v -> v > from && v < until);
    List<Section> sections =
        fitter.fit(
            robot,
            pose,
            waypoints,
            lanes.cells().resolution(),
            new PassingPlaces.CellPlaces(lanes.cells(), false));
    if (!DirectionCheck.isKept(lanes.cells().rules(), pose, sections)) {
      return false;
    }
    robot.drive.replaceUnreleased(
        sections, JointPlan.visitsAtEnds(lanes.cells(), pose, sections, visits, from));
    robot.waiting.restartBlocked();
    return true;
  }
}
