package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.traffic.floor.ManualStep.Granted;
import org.toqa.traffic.floor.ManualStep.NotNeeded;
import org.toqa.traffic.floor.ManualStep.Reason;
import org.toqa.traffic.floor.ManualStep.Refused;

/**
 * Lets a person drive a robot by hand: step by step, each so short that the robot stands soon after
 * the last one, and only where nothing is and nobody else may drive. What is granted is the robot's
 * own as any section is that is released to it, so all that holds for planned paths holds here.
 */
final class ManualSteps {
  /** Metres kept from walls and obstacles, as where there is no room for more. */
  private static final double FROM_WALLS = 0.02;

  /** Seconds; a shorter step is not worth a message. */
  private static final double SHORTEST = 0.05;

  private final OccupancyGrid grid;
  private final FreeSpace freeSpace;
  private final Claims claims;

  ManualSteps(OccupancyGrid grid, Margins margins, Claims claims) {
    this.grid = grid;
    this.freeSpace = new FreeSpace(grid, margins);
    this.claims = claims;
  }

  /**
   * @param robot stands without a path, or drives what was granted here
   * @param obstacles those that are there now
   * @param twist vx metres a second, w radians a second; not both 0
   * @param ahead seconds of driving that the robot shall have then, all in all
   */
  ManualStep take(TrafficRobot robot, Obstacles obstacles, Twist twist, double ahead) {
    double seconds = ahead - Allocation.secondsAhead(robot);
    if (seconds < SHORTEST) {
      return new NotNeeded();
    }
    freeSpace.setObstacles(obstacles);
    Pose from = robot.committedEnd();
    Section section = section(robot, from, new Segment(twist.vx(), twist.w(), seconds));
    Refused refused = refusal(robot, from, section);
    if (refused != null) {
      return refused;
    }
    robot.continueOn(ReservedPath.independent(from, List.of(section)));
    robot.drive.releaseAll();
    return new Granted(robot.drive.takeUnsentCommand(robot.name, true).orElseThrow());
  }

  /** As slow as the floor wants, and so long at most. */
  private static Section section(TrafficRobot robot, Pose from, Segment wanted) {
    List<Segment> segments = new ArrayList<>();
    List<SweptArea> areas = new ArrayList<>();
    Pose at = from;
    double left = wanted.t();
    for (Segment piece : robot.limited(from, wanted)) {
      if (left <= 0) {
        break;
      }
      Segment driven = piece.lasting(Math.min(piece.t(), left));
      segments.add(driven);
      areas.add(robot.sweptArea(at, driven));
      at = at.advanced(driven.twist(), driven.t());
      left -= driven.t();
    }
    return robot.section(segments, at, SweptArea.union(areas), false);
  }

  private @Nullable Refused refusal(TrafficRobot robot, Pose from, Section section) {
    Set<TrafficRobot> others = claims.tooNear(robot, robot.areaAt(from), section.area());
    if (!others.isEmpty()) {
      return new Refused(Reason.ROBOT, others.iterator().next().name);
    }
    List<Section> driven = List.of(section);
    if (leavesMap(from, section, robot.radius())) {
      return new Refused(Reason.WALL, null);
    }
    if (!freeSpace.seenBy(robot).hasRoom(robot, driven, FROM_WALLS)) {
      return new Refused(isWall(section) ? Reason.WALL : Reason.OBSTACLE, null);
    }
    return DirectionCheck.isKept(grid.rules(), from, driven)
        ? null
        : new Refused(Reason.DIRECTION, null);
  }

  private boolean isWall(Section section) {
    BitSet near = new BitSet();
    section.area().cells(grid, FROM_WALLS).addTo(near);
    return near.intersects(grid.occupied());
  }

  /** Whether it comes nearer to the end of the map than the disc allows, and than it was. */
  private boolean leavesMap(Pose from, Section section, double radius) {
    double there = toEnd(section.end().position());
    return there < radius && there < toEnd(from.position());
  }

  /** Metres to the nearest end of the map; below 0 beside it. */
  private double toEnd(Vec2 point) {
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    Vec2 in = point.minus(grid.origin());
    return Math.min(Math.min(in.x(), size.x() - in.x()), Math.min(in.y(), size.y() - in.y()));
  }
}
