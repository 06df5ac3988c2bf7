package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.toqa.avoidance.Bypass;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.FreeZone;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;

/**
 * Lends a robot room beside its path to drive round something small that it sees there (Tanta,
 * "Obstacle avoidance on the robot"): where that is nobody's, off walls and known obstacles, and
 * where all of the path until it is back can be released with it. So who was lent room drives on
 * whatever others do, and waits for nobody with it.
 */
final class RoomLender {
  /** Metres beside the path at most. */
  private static final double WIDEST = 0.45;

  /** Metres more than what is seen of the thing needs: it may be wider than that. */
  private static final List<Double> SPARE = List.of(0.10, 0.05, 0.02);

  /** Metres that are kept from walls, and from obstacles that others saw. */
  private static final double OFF_WALLS = 0.05;

  /** Metres behind the thing, until the robot is back on its path. */
  private static final double RETURN = 0.9;

  /** Metres; what is so near to what the robot sees belongs to that. */
  private static final double SAME_THING = 0.3;

  /** Metres from line to line of what a robot covers that may be anywhere between. */
  private static final double LINES = 0.1;

  /** Radians; an arc is taken as chords that turn no more. */
  private static final double CHORD = 0.2;

  /** On the inner side of a bend a robot drives no shorter than this part of its path. */
  private static final double INSIDE = 0.5;

  private final OccupancyGrid grid;
  private final BitSet walls;
  private final Claims claims;
  private final SectionReleaser releaser;

  RoomLender(OccupancyGrid grid, Claims claims, SectionReleaser releaser) {
    this.grid = grid;
    this.walls = grid.occupied();
    this.claims = claims;
    this.releaser = releaser;
  }

  /**
   * The way until the robot is back on its path.
   *
   * @param from the segment that the robot is on
   * @param starts where each segment begins, map frame
   */
  private record Stretch(int from, List<Pose> starts, List<Segment> segments) {
    int to() {
      return from + segments.size();
    }
  }

  /**
   * Lends it room, and releases what it needs of its path, if both can be.
   *
   * @param seen points on or beside its path, map frame
   * @param obstacles those that are known, the robot's own among them
   * @return whether it has room now
   */
  boolean lend(TrafficRobot robot, List<Vec2> seen, BitSet obstacles, Instant now) {
    ReservedPath path = robot.drive.path();
    if (path == null
        || !robot.isMovable()
        || robot.isStalled()
        || robot.isFormation()
        || robot.drive.lentRoom() != null) {
      return false;
    }
    Optional<LentRoom> lent =
        stretch(robot, path, seen).flatMap(s -> room(robot, s, seen, obstacles));
    if (lent.isEmpty() || !releaser.releaseUntil(robot, lent.get().room().to(), now)) {
      return false;
    }
    lent.get().areas().forEach(area -> claims.add(robot, area));
    robot.drive.lend(lent.get());
    return true;
  }

  /** The room that a robot was lent by an earlier server. */
  static LentRoom lentBefore(TrafficRobot robot, ReservedPath path, PassingRoom room) {
    FreeZone zone = room.zone();
    if (zone != null) {
      return new LentRoom(room, List.of(ZoneLender.whole(zone, robot.radius())));
    }
    List<Segment> segments = path.segmentsFrom(0);
    List<SweptArea> areas = new ArrayList<>();
    Pose pose = path.start();
    for (int i = 0; i < Math.min(room.to(), segments.size()); i++) {
      if (i >= room.from()) {
        areas.add(area(robot.radius(), pose, segments.get(i), room.left(), room.right()));
      }
      pose = pose.advanced(segments.get(i).twist(), segments.get(i).t());
    }
    return new LentRoom(room, areas);
  }

  private static Optional<Stretch> stretch(TrafficRobot robot, ReservedPath path, List<Vec2> seen) {
    int from = robot.drive.completedSegments();
    List<Segment> segments = path.segmentsFrom(0);
    Pose pose = path.trajectory().poseAfter(from);
    List<Pose> starts = new ArrayList<>();
    double behindThing = Double.NEGATIVE_INFINITY;
    for (int i = from; i < segments.size(); i++) {
      Segment segment = segments.get(i);
      if (segment.v() <= 0) {
        return Optional.empty();
      }
      starts.add(pose);
      Pose end = pose.advanced(segment.twist(), segment.t());
      double reach = robot.radius() + Bypass.LEAST_GAP;
      boolean isBeside = false;
      for (Vec2 point : seen) {
        isBeside |= point.distanceToLine(pose.position(), end.position()) < reach;
      }
      behindThing = isBeside ? 0 : behindThing + segment.length();
      if (behindThing >= RETURN) {
        return Optional.of(new Stretch(from, starts, segments.subList(from, i + 1)));
      }
      pose = end;
    }
    return Optional.empty();
  }

  private Optional<LentRoom> room(
      TrafficRobot robot, Stretch stretch, List<Vec2> seen, BitSet obstacles) {
    double left = needed(robot, stretch, seen, 1);
    double right = needed(robot, stretch, seen, -1);
    BitSet closed = otherObstacles(obstacles, seen);
    closed.or(walls);
    List<Boolean> sides = left <= right ? List.of(true, false) : List.of(false, true);
    for (boolean isLeft : sides) {
      for (double spare : SPARE) {
        double width = (isLeft ? left : right) + spare;
        Optional<LentRoom> room = room(robot, stretch, isLeft, width, closed);
        if (room.isPresent()) {
          return room;
        }
      }
    }
    return Optional.empty();
  }

  /**
   * Metres beside the path to get by on a side.
   *
   * @param side 1: on the left; -1: on the right
   */
  private static double needed(TrafficRobot robot, Stretch stretch, List<Vec2> seen, int side) {
    double most = 0;
    for (Vec2 point : seen) {
      double nearest = robot.radius() + Bypass.LEAST_GAP;
      double reaches = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < stretch.segments().size(); i++) {
        Pose start = stretch.starts().get(i);
        Segment segment = stretch.segments().get(i);
        Vec2 end = start.advanced(segment.twist(), segment.t()).position();
        double distance = point.distanceToLine(start.position(), end);
        if (distance < nearest) {
          Vec2 way = end.minus(start.position());
          nearest = distance;
          reaches = side * point.minus(start.position()).rotated(-way.angle()).y();
        }
      }
      most = Math.max(most, reaches + robot.radius() + Bypass.PASSING_GAP);
    }
    return most;
  }

  /** What is not what the robot sees itself. */
  private BitSet otherObstacles(BitSet obstacles, List<Vec2> seen) {
    BitSet others = (BitSet) obstacles.clone();
    double near = SAME_THING + grid.resolution() / 2;
    for (int cell = others.nextSetBit(0); cell >= 0; cell = others.nextSetBit(cell + 1)) {
      Vec2 middle = grid.centre(grid.cell(cell));
      if (seen.stream().anyMatch(point -> point.distanceTo(middle) < near)) {
        others.clear(cell);
      }
    }
    return others;
  }

  private Optional<LentRoom> room(
      TrafficRobot robot, Stretch stretch, boolean isLeft, double width, BitSet closed) {
    if (width > WIDEST) {
      return Optional.empty();
    }
    double left = isLeft ? width : 0;
    double right = isLeft ? 0 : width;
    List<SweptArea> areas = new ArrayList<>();
    for (int i = 0; i < stretch.segments().size(); i++) {
      Pose start = stretch.starts().get(i);
      Segment segment = stretch.segments().get(i);
      double bend = segment.w() / segment.v();
      SweptArea area = area(robot.radius(), start, segment, left, right);
      boolean isFree =
          bend * left <= INSIDE
              && -bend * right <= INSIDE
              && keepsDirections(start, segment, left - right)
              && !area.cells(grid, OFF_WALLS).intersects(closed)
              && claims.tooNear(robot, robot.standingArea(), area).isEmpty();
      if (!isFree) {
        return Optional.empty();
      }
      areas.add(area);
    }
    return Optional.of(
        new LentRoom(new PassingRoom(stretch.from(), stretch.to(), left, right), areas));
  }

  private boolean keepsDirections(Pose start, Segment segment, double aside) {
    Pose end = start.advanced(segment.twist(), segment.t());
    return grid.rules().metresAgainst(beside(start, aside), beside(end, aside)) == 0;
  }

  /** All that a robot can cover beside a segment. */
  private static SweptArea area(
      double radius, Pose start, Segment segment, double left, double right) {
    int lines = (int) Math.ceil((left + right) / LINES);
    int chords = Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / CHORD));
    List<SweptArea> parts = new ArrayList<>();
    Pose pose = start;
    for (int chord = 0; chord < chords; chord++) {
      Pose next = pose.advanced(segment.twist(), segment.t() / chords);
      // height of an arc over its chord: R (1 - cos(angle/2))
      double turned = Math.abs(segment.angle()) / chords;
      double height =
          turned == 0 ? 0 : segment.length() / chords / turned * (1 - Math.cos(turned / 2));
      for (int line = 0; line <= lines; line++) {
        double aside = lines == 0 ? left : left - (left + right) * line / lines;
        parts.add(SweptArea.along(beside(pose, aside), beside(next, aside), radius + height));
      }
      pose = next;
    }
    return SweptArea.union(parts);
  }

  private static Vec2 beside(Pose pose, double left) {
    return pose.compose(new Pose(0, left, 0)).position();
  }
}
