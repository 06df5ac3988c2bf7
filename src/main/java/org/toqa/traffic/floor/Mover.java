package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** A robot in {@link FloorTraffic}: where it stands, what it has of the floor, where it goes. */
final class Mover {
  final String name;
  private final OccupancyGrid grid;

  Pose pose;
  double radius;
  boolean movable;
  @Nullable Vec2 goal;

  @Nullable Course course;

  /** Counts its courses, so that a wait for an old one counts as over. */
  int courseNumber;

  /** Whether the robot does not know yet that what was not released is given up. */
  boolean isCutUntold;

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

  /** Whether its own smooth way was looked for since something last changed. */
  boolean triedAlone;

  /** Why it has no way to its goal, for people. */
  @Nullable String reason;

  /** Why it does not go on with its way, for people. */
  @Nullable String obstruction;

  /** The cells that a robot too large to be planned with the others waits for to become free. */
  BitSet wish = new BitSet();

  Mover(String name, OccupancyGrid grid, Pose pose, double radius, Instant now) {
    this.name = name;
    this.grid = grid;
    this.pose = pose;
    this.radius = radius;
    this.lastProgress = now;
  }

  /** The cells that are its own now: where it stands, and all of what it may drive. */
  BitSet held() {
    BitSet cells = SweptCells.standing(grid, pose.position(), radius);
    Course way = course;
    if (way != null) {
      cells.or(way.cells(Math.min(done, released), released));
      cells.or(SweptCells.standing(grid, way.poseAfter(released).position(), radius));
    }
    return cells;
  }

  /** The cells that it holds or will need. */
  BitSet claimed() {
    BitSet cells = held();
    Course way = course;
    if (way != null) {
      cells.or(way.cells(Math.min(done, way.size()), way.size()));
    }
    return cells;
  }

  /** Where it will stand when it has driven what is released. */
  Pose releasedEnd() {
    return course == null ? pose : course.poseAfter(released);
  }

  Cell releasedCell() {
    return grid.cellAt(releasedEnd().position());
  }

  boolean isAtGoal() {
    return goal != null && course == null && grid.cellAt(pose.position()).equals(goalCell());
  }

  @Nullable Cell goalCell() {
    return goal == null ? null : grid.cellAt(goal);
  }

  /** Wants to go somewhere and has no way there, or only one that ends short of it. */
  boolean isUnserved() {
    if (goal == null || !movable) {
      return false;
    }
    Course way = course;
    if (way == null) {
      return !isAtGoal();
    }
    return released == way.size()
        && !grid.cellAt(way.poseAfter(way.size()).position()).equals(goalCell());
  }

  boolean isDriving() {
    return course != null && done < released;
  }

  boolean hasUnreleased() {
    return course != null && released < course.size();
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
    blockedSince = null;
  }

  /** Gives up what is not released. */
  void cut() {
    Course way = course;
    if (way != null && released < way.size()) {
      course = way.continued(released, Course.meetingNobody(releasedEnd(), List.of()));
      courseNumber++;
      isCutUntold = true;
    }
  }
}
