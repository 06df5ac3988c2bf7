package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;

/** A robot in {@link FloorTraffic}: where it stands, what it has of the floor, where it goes. */
final class Mover {
  /** So near to its goal, metres, a robot has arrived. */
  private static final double ARRIVED = 0.03;

  /** So near to the middle of a cell, in cells, a robot stands in it. */
  private static final double NEAR = 0.2;

  /** So nearly, radians, it faces as it shall. */
  private static final double FACING = 0.05;

  final String name;

  /** Above 0, all different. */
  final int number;

  private final OccupancyGrid grid;

  Pose pose;
  double radius;
  DriveSpeeds speeds = DriveSpeeds.DEFAULT;
  boolean movable;
  @Nullable Vec2 goal;

  /** How it shall face at its goal, radians; null: in any way. */
  @Nullable Double heading;

  /** What drives with it as one; null: it drives alone. */
  private @Nullable Group group;

  @Nullable Course course;

  /** Counts its courses, so that a wait for an old one counts as over. */
  int courseNumber;

  /** Whether the robot was told to begin the course. */
  boolean begun;

  /** So many stretches the robot was told that it may drive. */
  int toldReleased;

  /** Whether the robot does not know yet that its way goes on otherwise behind these. */
  boolean redriven;

  /** Stretches of the course that are completed. */
  int done;

  /** Stretches of the course that it may drive. */
  int released;

  /** Since when it stands short of its goal; null while it drives or wants nothing. */
  @Nullable Instant waitingSince;

  /** When it last completed a stretch or was given one to drive. */
  Instant lastProgress;

  /** Since when it stands before a stretch that it may not enter. */
  @Nullable Instant blockedSince;

  /** Whether it has not gone on for much longer than its way says. */
  boolean stalled;

  /** When its own smooth way was last looked for. */
  Instant triedAlone = Instant.MIN;

  /** Why it has no way to its goal; null while it has. */
  @Nullable Hindrance hindrance;

  /** When the hindrance was found. */
  Instant hindranceSince = Instant.MIN;

  /** Who has its goal, by the last plan for all. */
  @Nullable String takenBy;

  /** Why it may not enter the next stretch of its way; null while it may. */
  @Nullable Hindrance obstruction;

  /** The cells that a robot too large to be planned with the others waits for to become free. */
  BitSet wish = new BitSet();

  private CellSet standing;

  /** Where its last way ended, which it came to but for what a robot is off its place. */
  private @Nullable Pose rest;

  Mover(String name, int number, OccupancyGrid grid, Pose pose, double radius, Instant now) {
    this.name = name;
    this.number = number;
    this.grid = grid;
    this.pose = pose;
    this.radius = radius;
    this.lastProgress = now;
    this.standing = SweptCells.standing(grid, pose.position(), radius);
  }

  void isAt(Pose now, double itsRadius) {
    boolean isSame =
        itsRadius == radius
            && (group == null ? now.position().equals(pose.position()) : now.equals(pose));
    pose = now;
    radius = itsRadius;
    if (!isSame) {
      standing = standingAt(now);
    }
  }

  /** Others drive with it as one from now on; null: it drives alone. */
  void leads(@Nullable Group next) {
    group = next;
    standing = standingAt(pose);
  }

  @Nullable Group group() {
    return group;
  }

  /** Where it is, and those that drive with it. */
  List<Round> discs() {
    return group == null ? List.of(new Round(pose.position(), radius)) : group.discs(pose);
  }

  /** The cells under it when it stands there. */
  CellSet standingAt(Pose at) {
    return group == null
        ? SweptCells.standing(grid, at.position(), radius)
        : group.standing(grid, at);
  }

  /** The cells that it touches while it drives the segment. */
  CellSet swept(Pose from, Segment segment) {
    return group == null
        ? SweptCells.of(grid, from, segment, radius)
        : group.swept(grid, from, segment);
  }

  /** How it shall face at a point; null: in any way. */
  @Nullable Double headingAt(Vec2 point) {
    return goal != null && heading != null && isAtGoalPoint(point) ? heading : null;
  }

  /** The cells under it. */
  CellSet standing() {
    return standing;
  }

  /** The cells that are its own now, in parts: where it stands, and all of what it may drive. */
  void forEachHeld(Consumer<CellSet> consumer) {
    consumer.accept(standing);
    Course way = course;
    if (way != null) {
      for (int i = Math.min(done, released); i < released; i++) {
        consumer.accept(way.stretches().get(i).cells());
      }
      if (released > 0) {
        consumer.accept(way.stretches().get(released - 1).endCells());
      }
    }
  }

  BitSet held() {
    BitSet cells = new BitSet();
    forEachHeld(part -> part.addTo(cells));
    return cells;
  }

  /** Adds the cells that it holds or will need. */
  void addClaimedTo(BitSet cells) {
    forEachHeld(part -> part.addTo(cells));
    Course way = course;
    if (way != null) {
      for (int i = released; i < way.size(); i++) {
        way.stretches().get(i).cells().addTo(cells);
      }
    }
  }

  /** Where it will stand when it has driven what is released, and where its way goes on. */
  Pose releasedEnd() {
    if (course != null) {
      return course.poseAfter(released);
    }
    if (group == null) {
      return pose;
    }
    return rest != null && GroupWays.isAt(rest, pose) ? rest : GroupWays.start(grid, pose);
  }

  /** The cell where it is. */
  Cell cell() {
    return grid.cellAt(pose.position());
  }

  Cell releasedCell() {
    return grid.cellAt(releasedEnd().position());
  }

  boolean isAtGoal() {
    return goal != null && course == null && isGoal(pose);
  }

  /** Whether who stands there stands at its goal, or where it fills a cell, in that of its goal. */
  boolean isGoal(Pose place) {
    if (goal == null) {
      return false;
    }
    if (group != null) {
      Vec2 load = group.shape().loadAt(place).position();
      return load.distanceTo(goal) < GroupWays.nearness(grid);
    }
    boolean facesRight =
        heading == null || Math.abs(Angles.difference(place.theta(), heading)) < FACING;
    return facesRight && isAtGoalPoint(place.position());
  }

  private boolean isAtGoalPoint(Vec2 point) {
    Vec2 wanted = Objects.requireNonNull(goal);
    boolean fillsCell = Lanes.side(grid, 2 * radius) == 1;
    double aside = point.distanceTo(grid.centre(grid.cellAt(wanted)));
    return point.distanceTo(wanted) < ARRIVED
        || (fillsCell && aside < Math.max(ARRIVED, NEAR * grid.resolution()));
  }

  @Nullable Cell goalCell() {
    return goal == null ? null : grid.cellAt(goal);
  }

  /** Wants to go somewhere and has no way there, or only one that ends short of it. */
  boolean isUnserved() {
    return goal != null && movable && released == size() && !isGoal(releasedEnd());
  }

  /** Wants to go somewhere, and is there or on its way. */
  boolean isServed() {
    return goal != null && isGoal(course == null ? pose : course.end());
  }

  /** Whether what it has not been released yet needs one of the cells. */
  boolean needsAny(BitSet cells) {
    Course way = course;
    return way != null
        && way.stretches().subList(released, way.size()).stream()
            .anyMatch(s -> s.cells().intersects(cells));
  }

  /** Waits, and is served first: a group, which cannot step aside, then who waits longest. */
  boolean goesBefore(Mover other) {
    if (waitingSince == null || isGroup() != other.isGroup()) {
      return waitingSince != null && isGroup();
    }
    return other.waitingSince == null || waitingSince.isBefore(other.waitingSince);
  }

  boolean isGroup() {
    return group != null;
  }

  /** Why it does not get on; null while it does. */
  @Nullable Hindrance why() {
    if (hindrance != null) {
      return hindrance;
    }
    return isDriving() ? null : obstruction;
  }

  private int size() {
    return course == null ? released : course.size();
  }

  boolean isDriving() {
    return course != null && done < released;
  }

  boolean hasUnreleased() {
    return course != null && released < course.size();
  }

  /** Whether what is left of its way was planned together with others' ways. */
  boolean isOnSharedWay() {
    return course != null && course.isShared() && hasUnreleased();
  }

  /** Begins another way where the released part of this one ends. */
  void take(Course next) {
    Course way = course;
    course = way == null ? next : way.continued(released, next);
    if (way == null) {
      done = 0;
      released = 0;
    }
    courseNumber++;
    redriven = true;
    blockedSince = null;
    obstruction = null;
    triedAlone = Instant.MIN;
  }

  /** It stands and has no way. */
  void stop() {
    rest = course == null ? rest : releasedEnd();
    course = null;
    done = 0;
    released = 0;
    begun = false;
    toldReleased = 0;
    redriven = false;
    obstruction = null;
  }

  /** Gives up what is not released. */
  void cut() {
    Course way = course;
    if (way != null && released < way.size()) {
      course = way.continued(released, Course.meetingNobody(releasedEnd(), List.of()));
      courseNumber++;
      redriven = true;
      obstruction = null;
    }
  }

  /** What the robot does not know yet of its course, if anything; counts as told from now on. */
  Optional<Decision> untold() {
    Course way = course;
    if (way == null || !movable) {
      return Optional.empty();
    }
    int count = way.segmentsOf(released);
    boolean endsAtGoal = goal == null || isGoal(way.end());
    Decision decision = null;
    if (!begun) {
      decision = new Decision.Begin(name, way.trajectory(), count, endsAtGoal);
    } else if (redriven) {
      decision =
          new Decision.Extend(
              name,
              way.segmentsOf(toldReleased),
              way.segmentsFrom(toldReleased),
              count,
              endsAtGoal);
    } else if (released > toldReleased) {
      decision = new Decision.Release(name, count);
    }
    begun = true;
    redriven = false;
    toldReleased = released;
    return Optional.ofNullable(decision);
  }
}
