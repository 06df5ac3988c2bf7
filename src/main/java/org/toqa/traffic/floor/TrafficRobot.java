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
final class TrafficRobot {
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
  @Nullable Double goalHeading;

  /** What drives with it as one; null: it drives alone. */
  private @Nullable FormationFootprint formation;

  @Nullable ReservedPath path;

  /** Counts its courses, so that a wait for an old one counts as over. */
  int pathNumber;

  /** Whether the robot was told to begin the course. */
  boolean isDriveStarted;

  /** So many stretches the robot was told that it may drive. */
  int sentReleased;

  /** Whether the robot does not know yet that its way goes on otherwise behind these. */
  boolean isChangeUnsent;

  /** Stretches of the course that are completed. */
  int completed;

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
  Instant lastSinglePlan = Instant.MIN;

  /** Why it has no way to its goal; null while it has. */
  @Nullable WaitReason noPathReason;

  /** When the hindrance was found. */
  Instant noPathReasonFound = Instant.MIN;

  /** Who has its goal, by the last plan for all. */
  @Nullable String goalTakenBy;

  /** Why it may not enter the next stretch of its way; null while it may. */
  @Nullable WaitReason blockedReason;

  /** The cells that a robot too large to be planned with the others waits for to become free. */
  BitSet wantedCells = new BitSet();

  private CellSet standingCells;

  /** Where its last way ended, which it came to but for what a robot is off its place. */
  private @Nullable Pose lastPathEnd;

  TrafficRobot(String name, int number, OccupancyGrid grid, Pose pose, double radius, Instant now) {
    this.name = name;
    this.number = number;
    this.grid = grid;
    this.pose = pose;
    this.radius = radius;
    this.lastProgress = now;
    this.standingCells = SweptCells.at(grid, pose.position(), radius);
  }

  void setPose(Pose newPose, double newRadius) {
    boolean isSame =
        newRadius == radius
            && (formation == null
                ? newPose.position().equals(pose.position())
                : newPose.equals(pose));
    pose = newPose;
    radius = newRadius;
    if (!isSame) {
      standingCells = cellsAt(newPose);
    }
  }

  /** Others drive with it as one from now on; null: it drives alone. */
  void setFormation(@Nullable FormationFootprint newFormation) {
    formation = newFormation;
    standingCells = cellsAt(pose);
  }

  @Nullable FormationFootprint formation() {
    return formation;
  }

  /** Where it is, and those that drive with it. */
  List<PlacedDisc> discs() {
    return formation == null
        ? List.of(new PlacedDisc(pose.position(), radius))
        : formation.discs(pose);
  }

  /** The cells under it when it stands there. */
  CellSet cellsAt(Pose at) {
    return formation == null
        ? SweptCells.at(grid, at.position(), radius)
        : formation.cellsAt(grid, at);
  }

  /** The cells that it touches while it drives the segment. */
  CellSet sweptCells(Pose from, Segment segment) {
    return formation == null
        ? SweptCells.alongSegment(grid, from, segment, radius)
        : formation.sweptCells(grid, from, segment);
  }

  /** How it shall face at a point; null: in any way. */
  @Nullable Double requiredHeadingAt(Vec2 point) {
    return goal != null && goalHeading != null && isAtGoalPoint(point) ? goalHeading : null;
  }

  /** The cells under it. */
  CellSet standingCells() {
    return standingCells;
  }

  /** The cells that are its own now, in parts: where it stands, and all of what it may drive. */
  void forEachAllocated(Consumer<CellSet> consumer) {
    consumer.accept(standingCells);
    ReservedPath reserved = path;
    if (reserved != null) {
      for (int i = Math.min(completed, released); i < released; i++) {
        consumer.accept(reserved.sections().get(i).cells());
      }
      if (released > 0) {
        consumer.accept(reserved.sections().get(released - 1).endCells());
      }
    }
  }

  BitSet allocatedCells() {
    BitSet cells = new BitSet();
    forEachAllocated(part -> part.addTo(cells));
    return cells;
  }

  /** Adds the cells that it holds or will need. */
  void addClaimedTo(BitSet cells) {
    forEachAllocated(part -> part.addTo(cells));
    ReservedPath reserved = path;
    if (reserved != null) {
      for (int i = released; i < reserved.sectionCount(); i++) {
        reserved.sections().get(i).cells().addTo(cells);
      }
    }
  }

  /** Where it will stand when it has driven what is released, and where its way goes on. */
  Pose releasedEnd() {
    if (path != null) {
      return path.poseAfter(released);
    }
    if (formation == null) {
      return pose;
    }
    return lastPathEnd != null && FormationPlanner.isAtPlace(lastPathEnd, pose)
        ? lastPathEnd
        : FormationPlanner.start(grid, pose);
  }

  /** The cell where it is. */
  Cell cell() {
    return grid.cellAt(pose.position());
  }

  Cell releasedCell() {
    return grid.cellAt(releasedEnd().position());
  }

  boolean isAtGoal() {
    return goal != null && path == null && isGoal(pose);
  }

  /** Whether who stands there stands at its goal, or where it fills a cell, in that of its goal. */
  boolean isGoal(Pose place) {
    if (goal == null) {
      return false;
    }
    if (formation != null) {
      Vec2 load = formation.shape().loadAt(place).position();
      return load.distanceTo(goal) < FormationPlanner.goalTolerance(grid);
    }
    boolean facesRight =
        goalHeading == null || Math.abs(Angles.difference(place.theta(), goalHeading)) < FACING;
    return facesRight && isAtGoalPoint(place.position());
  }

  private boolean isAtGoalPoint(Vec2 point) {
    Vec2 wanted = Objects.requireNonNull(goal);
    boolean fillsCell = LaneGrid.side(grid, 2 * radius) == 1;
    double aside = point.distanceTo(grid.centre(grid.cellAt(wanted)));
    return point.distanceTo(wanted) < ARRIVED
        || (fillsCell && aside < Math.max(ARRIVED, NEAR * grid.resolution()));
  }

  @Nullable Cell goalCell() {
    return goal == null ? null : grid.cellAt(goal);
  }

  /** Wants to go somewhere and has no way there, or only one that ends short of it. */
  boolean needsPath() {
    return goal != null && movable && released == sectionCount() && !isGoal(releasedEnd());
  }

  /** Wants to go somewhere, and is there or on its way. */
  boolean hasPathToGoal() {
    return goal != null && isGoal(path == null ? pose : path.end());
  }

  /** Whether what it has not been released yet needs one of the cells. */
  boolean hasUnreleasedOn(BitSet cells) {
    ReservedPath reserved = path;
    return reserved != null
        && reserved.sections().subList(released, reserved.sectionCount()).stream()
            .anyMatch(s -> s.cells().intersects(cells));
  }

  /** Waits, and is served first: a group, which cannot step aside, then who waits longest. */
  boolean hasPrecedenceOver(TrafficRobot other) {
    if (waitingSince == null || isFormation() != other.isFormation()) {
      return waitingSince != null && isFormation();
    }
    return other.waitingSince == null || waitingSince.isBefore(other.waitingSince);
  }

  boolean isFormation() {
    return formation != null;
  }

  /** Why it does not get on; null while it does. */
  @Nullable WaitReason waitReason() {
    if (noPathReason != null) {
      return noPathReason;
    }
    return isDriving() ? null : blockedReason;
  }

  private int sectionCount() {
    return path == null ? released : path.sectionCount();
  }

  boolean isDriving() {
    return path != null && completed < released;
  }

  boolean hasUnreleased() {
    return path != null && released < path.sectionCount();
  }

  /** Whether what is left of its way was planned together with others' ways. */
  boolean isOnSharedPath() {
    return path != null && path.isShared() && hasUnreleased();
  }

  /** Begins another way where the released part of this one ends. */
  void continueOn(ReservedPath next) {
    ReservedPath former = path;
    path = former == null ? next : former.continuedWith(released, next);
    if (former == null) {
      completed = 0;
      released = 0;
    }
    pathNumber++;
    isChangeUnsent = true;
    blockedSince = null;
    blockedReason = null;
    lastSinglePlan = Instant.MIN;
  }

  /** It stands and has no way. */
  void stop() {
    lastPathEnd = path == null ? lastPathEnd : releasedEnd();
    path = null;
    completed = 0;
    released = 0;
    isDriveStarted = false;
    sentReleased = 0;
    isChangeUnsent = false;
    blockedReason = null;
  }

  /** Gives up what is not released. */
  void freeUnreleased() {
    ReservedPath former = path;
    if (former != null && released < former.sectionCount()) {
      path = former.continuedWith(released, ReservedPath.independent(releasedEnd(), List.of()));
      pathNumber++;
      isChangeUnsent = true;
      blockedReason = null;
    }
  }

  /** What the robot does not know yet of its course, if anything; counts as told from now on. */
  Optional<DriveCommand> takeUnsentCommand() {
    ReservedPath reserved = path;
    if (reserved == null || !movable) {
      return Optional.empty();
    }
    int count = reserved.segmentCount(released);
    boolean endsAtGoal = goal == null || isGoal(reserved.end());
    DriveCommand command = null;
    if (!isDriveStarted) {
      command = new DriveCommand.Begin(name, reserved.trajectory(), count, endsAtGoal);
    } else if (isChangeUnsent) {
      command =
          new DriveCommand.Extend(
              name,
              reserved.segmentCount(sentReleased),
              reserved.segmentsFrom(sentReleased),
              count,
              endsAtGoal);
    } else if (released > sentReleased) {
      command = new DriveCommand.Release(name, count);
    }
    isDriveStarted = true;
    isChangeUnsent = false;
    sentReleased = released;
    return Optional.ofNullable(command);
  }
}
