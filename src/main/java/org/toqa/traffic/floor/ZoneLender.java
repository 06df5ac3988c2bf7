package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.FreeZone;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;

/**
 * Lends a robot that finds its own way a free zone of the floor as a whole, where its path leads
 * through it: when nobody else has anything in it or near it, and all of the path up to where the
 * robot leaves the zone can be released with it. Until then the robot waits before the zone, for
 * {@link #PATIENCE} at most; then it follows its path through it, like robots that cannot do
 * otherwise.
 */
final class ZoneLender {
  /** So long a robot that stands before a zone waits until that is free. */
  static final Duration PATIENCE = Duration.ofSeconds(10);

  /** Metres of the path; a shorter way through a zone is followed. */
  private static final double SHORTEST = 0.6;

  /** A zone with more in it is driven by the path. */
  private static final int MOST_OBSTACLES = 16;

  /** Metres from line to line of what a robot covers that may be anywhere between. */
  private static final double LINES = 0.1;

  private static final double ROUNDING = 1e-6;

  private final OccupancyGrid grid;
  private final List<Area> zones;
  private final Claims claims;
  private final SectionReleaser releaser;

  ZoneLender(OccupancyGrid grid, Claims claims, SectionReleaser releaser) {
    this.grid = grid;
    this.zones = grid.rules().freeZones().stream().flatMap(zone -> onMap(zone).stream()).toList();
    this.claims = claims;
    this.releaser = releaser;
  }

  /** What of a zone is on the map. */
  private Optional<Area> onMap(Area zone) {
    Vec2 low = grid.origin();
    Vec2 high = low.plus(new Vec2(grid.width(), grid.height()).times(grid.resolution()));
    double west = Math.max(low.x(), zone.low().x());
    double south = Math.max(low.y(), zone.low().y());
    double width = Math.min(high.x(), zone.high().x()) - west;
    double height = Math.min(high.y(), zone.high().y()) - south;
    return width > 0 && height > 0
        ? Optional.of(new Area(new Vec2(west, south), width, height))
        : Optional.empty();
  }

  /**
   * A part of a path.
   *
   * @param from its first segment
   * @param to the first segment behind it
   * @param entry where it begins, map frame
   * @param exit where it ends
   * @param speed metres a second, the fastest on it
   */
  private record Crossing(Area zone, int from, int to, Vec2 entry, Vec2 exit, double speed) {}

  /**
   * How many sections may be released before a zone that the robot is to be lent first.
   *
   * @return without end: none
   */
  int sectionsBefore(TrafficRobot robot, Instant now) {
    Optional<Crossing> next = next(robot);
    ReservedPath path = robot.drive.path();
    if (next.isEmpty() || path == null || hasWaited(robot, now)) {
      return Integer.MAX_VALUE;
    }
    return sectionsBefore(path, next.get());
  }

  private static int sectionsBefore(ReservedPath path, Crossing crossing) {
    int count = path.completedSections(crossing.from());
    while (count > 0 && reachesInto(crossing.zone(), path.sections().get(count - 1).area())) {
      count--; // who waits for the zone does not stand in it
    }
    return count;
  }

  private static boolean reachesInto(Area zone, SweptArea area) {
    return area.east() > zone.low().x()
        && area.west() < zone.high().x()
        && area.north() > zone.low().y()
        && area.south() < zone.high().y();
  }

  private static boolean hasWaited(TrafficRobot robot, Instant now) {
    return !robot.drive.isDriving()
        && robot.waiting.blockedReason() != null
        && robot.waiting.blockedSince(now).plus(PATIENCE).isBefore(now);
  }

  /**
   * Lends it the zone that it has come to, and releases its path through it, if both can be.
   *
   * @param obstacles what is known of besides walls, as bits by {@link OccupancyGrid#index}
   * @return whether more may be released to it now: it has the zone, or is not lent it at all
   */
  boolean lend(TrafficRobot robot, BitSet obstacles, Instant now) {
    ReservedPath path = robot.drive.path();
    Crossing crossing = next(robot).orElse(null);
    if (path == null
        || crossing == null
        || !robot.isMovable()
        || robot.isStalled()
        || robot.drive.released() < sectionsBefore(path, crossing)) {
      return false;
    }
    List<FreeZone.Obstacle> known = obstaclesIn(crossing.zone(), obstacles);
    if (!isOpen(robot, crossing, known)) {
      return true;
    }
    SweptArea whole = whole(crossing.zone(), robot.radius());
    Set<TrafficRobot> others = claims.tooNear(robot, robot.standingArea(), whole);
    if (!others.isEmpty()) {
      if (!robot.drive.isDriving()) {
        robot.waiting.setBlockedReason(
            new WaitReason.RobotPassing(others.iterator().next().name, crossing.entry()));
        var _ = robot.waiting.blockedSince(now);
      }
      return false;
    }
    if (!releaser.releaseUntil(robot, crossing.to(), now)) {
      return false;
    }
    claims.add(robot, whole);
    Area zone = crossing.zone();
    FreeZone lent =
        new FreeZone(
            zone.low().x(), zone.low().y(), zone.width(), zone.height(), crossing.speed(), known);
    robot.drive.lend(
        new LentRoom(new PassingRoom(crossing.from(), crossing.to(), 0, 0, lent), List.of(whole)));
    return true;
  }

  /** All that a robot can cover in a zone. */
  static SweptArea whole(FreeZone zone, double radius) {
    return whole(new Area(new Vec2(zone.x(), zone.y()), zone.width(), zone.height()), radius);
  }

  private static SweptArea whole(Area zone, double radius) {
    // lines so near to each other that discs a little larger than the robot cover all between
    double larger = Math.hypot(radius, LINES / 2);
    Vec2 low = zone.low().plus(new Vec2(radius, radius));
    double width = Math.max(0, zone.width() - 2 * radius);
    double height = Math.max(0, zone.height() - 2 * radius);
    boolean isWide = width >= height;
    int lines = (int) Math.ceil((isWide ? height : width) / LINES);
    List<SweptArea> parts = new ArrayList<>();
    for (int line = 0; line <= lines; line++) {
      double share = lines == 0 ? 0 : (double) line / lines;
      Vec2 from = low.plus(isWide ? new Vec2(0, height * share) : new Vec2(width * share, 0));
      Vec2 to = from.plus(isWide ? new Vec2(width, 0) : new Vec2(0, height));
      parts.add(SweptArea.along(from, to, larger));
    }
    return SweptArea.union(parts);
  }

  /** Where its path leads next through a zone that it can be lent. */
  private Optional<Crossing> next(TrafficRobot robot) {
    ReservedPath path = robot.drive.path();
    if (zones.isEmpty()
        || path == null
        || !robot.findsOwnWay()
        || robot.isFormation()
        || robot.drive.lentRoom() != null) {
      return Optional.empty();
    }
    int first = robot.drive.completedSegments();
    List<Segment> segments = path.segmentsFrom(0);
    Pose pose = path.trajectory().poseAfter(first);
    for (int i = first; i < segments.size(); i++) {
      Area zone = zoneAt(robot, pose.position());
      if (zone != null) {
        Optional<Crossing> crossing = crossing(robot, zone, segments, i, pose);
        if (crossing.isPresent()) {
          return crossing;
        }
      }
      pose = pose.advanced(segments.get(i).twist(), segments.get(i).t());
    }
    return Optional.empty();
  }

  private Optional<Crossing> crossing(
      TrafficRobot robot, Area zone, List<Segment> segments, int from, Pose start) {
    Pose pose = start;
    double metres = 0;
    double speed = 0;
    int to = from;
    while (to < segments.size()) {
      Segment segment = segments.get(to);
      Pose end = pose.advanced(segment.twist(), segment.t());
      if (!isInside(zone, end.position(), robot.radius())) {
        break;
      }
      metres += segment.length();
      speed = Math.max(speed, Math.abs(segment.v()));
      pose = end;
      to++;
    }
    boolean isWorthwhile = metres >= SHORTEST && speed > 0;
    return isWorthwhile
        ? Optional.of(
            new Crossing(zone, from, to, start.position(), pose.position(), limited(zone, speed)))
        : Optional.empty();
  }

  /** The lowest limit that counts anywhere in the zone. */
  private double limited(Area zone, double speed) {
    return grid.rules().speedLimits().stream()
        .filter(limit -> limit.area().overlaps(zone))
        .mapToDouble(limit -> limit.speed())
        .reduce(speed, Math::min);
  }

  private @Nullable Area zoneAt(TrafficRobot robot, Vec2 point) {
    double least = 2 * robot.radius() + FreeZone.AIR;
    for (Area zone : zones) {
      if (zone.width() >= least
          && zone.height() >= least
          && !zone.equals(robot.givenUp())
          && isInside(zone, point, robot.radius())) {
        return zone;
      }
    }
    return null;
  }

  private static boolean isInside(Area zone, Vec2 middle, double radius) {
    return middle.x() >= zone.low().x() + radius - ROUNDING
        && middle.x() <= zone.high().x() - radius + ROUNDING
        && middle.y() >= zone.low().y() + radius - ROUNDING
        && middle.y() <= zone.high().y() - radius + ROUNDING;
  }

  /** Whether the robot can be let drive as it finds its way: no directions, nothing at the ends. */
  private boolean isOpen(TrafficRobot robot, Crossing crossing, List<FreeZone.Obstacle> known) {
    return known.size() <= MOST_OBSTACLES
        && known.stream()
            .allMatch(
                o ->
                    o.centre().distanceTo(crossing.entry()) > o.radius() + robot.radius()
                        && o.centre().distanceTo(crossing.exit()) > o.radius() + robot.radius())
        && grid.rules().oneWay().stream().noneMatch(way -> way.area().overlaps(crossing.zone()));
  }

  /** Circles round what stands in a zone: cells that touch are one thing. */
  private List<FreeZone.Obstacle> obstaclesIn(Area zone, BitSet obstacles) {
    BitSet left = grid.occupied();
    left.or(obstacles);
    left.and(zone.cells(grid));
    List<FreeZone.Obstacle> found = new ArrayList<>();
    while (!left.isEmpty() && found.size() <= MOST_OBSTACLES) {
      found.add(takeThing(left));
    }
    return found;
  }

  private FreeZone.Obstacle takeThing(BitSet left) {
    Deque<Cell> open = new ArrayDeque<>();
    Cell first = grid.cell(left.nextSetBit(0));
    open.add(first);
    left.clear(grid.index(first));
    double half = grid.resolution() / 2;
    Vec2 middle = grid.centre(first);
    double west = middle.x();
    double east = middle.x();
    double south = middle.y();
    double north = middle.y();
    while (!open.isEmpty()) {
      Cell cell = open.remove();
      middle = grid.centre(cell);
      west = Math.min(west, middle.x());
      east = Math.max(east, middle.x());
      south = Math.min(south, middle.y());
      north = Math.max(north, middle.y());
      for (int column = cell.column() - 1; column <= cell.column() + 1; column++) {
        for (int row = cell.row() - 1; row <= cell.row() + 1; row++) {
          Cell beside = new Cell(column, row);
          if (grid.contains(beside) && left.get(grid.index(beside))) {
            left.clear(grid.index(beside));
            open.add(beside);
          }
        }
      }
    }
    return new FreeZone.Obstacle(
        (west + east) / 2,
        (south + north) / 2,
        Math.hypot((east - west) / 2 + half, (north - south) / 2 + half));
  }
}
