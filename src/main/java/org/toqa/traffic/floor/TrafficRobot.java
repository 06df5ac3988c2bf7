package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** A robot in {@link FloorTraffic}: where it is, how large it is, where it goes. */
final class TrafficRobot {
  /** So near to its goal, metres, a robot has arrived. */
  private static final double ARRIVED = 0.03;

  /** So near to the middle of a cell, in cells, a robot is in it. */
  private static final double NEAR = 0.2;

  /** Metres: who has moved less stands where it stood. */
  private static final double SAME_PLACE = 0.01;

  /** So nearly, radians, it faces as it shall. */
  private static final double FACING = 0.05;

  final String name;

  /** Above 0, all different. */
  final int number;

  /** What it drives by. */
  final Drive drive;

  /** What it waits for. */
  final WaitState waiting;

  private final OccupancyGrid grid;
  private Pose pose;
  private double radius;
  private DriveSpeeds speeds = DriveSpeeds.DEFAULT;
  private boolean movable;
  private @Nullable Vec2 goal;

  /** How it shall face at its goal, radians; null: in any heading. */
  private @Nullable Double goalHeading;

  /** What drives with it as one; null: it drives alone. */
  private @Nullable FormationFootprint formation;

  /** Whether it has not gone on for much longer than its path takes. */
  private boolean stalled;

  /** Whether it finds its own way through a free zone that it is lent. */
  private boolean findsOwnWay;

  /** The free zone that it is not lent until it has left it and its path is over; null: none. */
  private @Nullable Area givenUp;

  /** The robot that stands on what this one may drive, where nobody expected it; null: none. */
  private @Nullable String cutOffBy;

  /** Where it stood when it was looked at last whom it cuts off. */
  private Vec2 lookedAt;

  /** What it covers where it is. */
  private SweptArea standingArea;

  /** How often that became another. */
  private long moves;

  TrafficRobot(String name, int number, OccupancyGrid grid, Pose pose, double radius, Instant now) {
    this.name = name;
    this.number = number;
    this.grid = grid;
    this.pose = pose;
    this.radius = radius;
    this.drive = new Drive(now);
    this.waiting = new WaitState();
    this.standingArea = SweptArea.at(pose.position(), radius);
    this.lookedAt = new Vec2(Double.NaN, Double.NaN);
  }

  private TrafficRobot(TrafficRobot other) {
    name = other.name;
    number = other.number;
    grid = other.grid;
    drive = other.drive.copy();
    waiting = other.waiting.copy();
    pose = other.pose;
    radius = other.radius;
    speeds = other.speeds;
    movable = other.movable;
    goal = other.goal;
    goalHeading = other.goalHeading;
    formation = other.formation;
    stalled = other.stalled;
    standingArea = other.standingArea;
    cutOffBy = other.cutOffBy;
    lookedAt = other.lookedAt;
  }

  /** Another one in the same state: neither learns what becomes of the other. */
  TrafficRobot copy() {
    return new TrafficRobot(this);
  }

  /** Whether it is to go to the same place as when it was pictured, and can as well as then. */
  boolean isUnchangedSince(TrafficRobot pictured) {
    return movable
        && stalled == pictured.stalled
        && Objects.equals(goal, pictured.goal)
        && Objects.equals(goalHeading, pictured.goalHeading)
        && speeds.equals(pictured.speeds)
        && radius == pictured.radius
        && formation == pictured.formation;
  }

  /** Where it is, map frame. */
  Pose pose() {
    return pose;
  }

  /** Of its own disc, metres. */
  double radius() {
    return radius;
  }

  DriveSpeeds speeds() {
    return speeds;
  }

  void setSpeeds(DriveSpeeds newSpeeds) {
    speeds = newSpeeds;
  }

  /** Whether it can be told to move. */
  boolean isMovable() {
    return movable;
  }

  void setMovable(boolean newMovable) {
    movable = newMovable;
  }

  @Nullable String cutOffBy() {
    return cutOffBy;
  }

  /** Another one stands where it was to drive; it must stop. */
  void cutOff(String by) {
    cutOffBy = by;
  }

  /** Whether it stands elsewhere than when it was asked last. */
  boolean isElsewhere() {
    if (pose.position().distanceTo(lookedAt) < SAME_PLACE) {
      return false;
    }
    lookedAt = pose.position();
    return true;
  }

  boolean isStalled() {
    return stalled;
  }

  void setStalled(boolean newStalled) {
    stalled = newStalled;
  }

  /** Where it shall go, metres, map frame; null: nowhere. */
  @Nullable Vec2 goal() {
    return goal;
  }

  /**
   * @param heading radians, map frame; null: in any heading
   * @return whether that is another goal than before
   */
  boolean setGoal(@Nullable Vec2 newGoal, @Nullable Double heading, Instant now) {
    if (Objects.equals(goal, newGoal) && Objects.equals(goalHeading, heading)) {
      return false;
    }
    goal = newGoal;
    goalHeading = heading;
    waiting.restart(newGoal == null ? null : now);
    waiting.restartStanding(now);
    return true;
  }

  boolean findsOwnWay() {
    return findsOwnWay;
  }

  void setFindsOwnWay(boolean itDoes) {
    findsOwnWay = itDoes;
  }

  /** The free zone that it follows its path through; null: none. */
  @Nullable Area givenUp() {
    return givenUp;
  }

  void setGivenUp(@Nullable Area zone) {
    givenUp = zone;
  }

  void setPose(Pose newPose, double newRadius) {
    if (givenUp != null && drive.path() == null && !givenUp.contains(newPose.position())) {
      givenUp = null;
    }
    boolean isSame =
        newRadius == radius
            && (formation == null
                ? newPose.position().equals(pose.position())
                : newPose.equals(pose));
    pose = newPose;
    radius = newRadius;
    if (!isSame) {
      standingArea = areaAt(newPose);
      moves++;
    }
  }

  /** Rises whenever it is elsewhere, or what is its own becomes another. */
  long changes() {
    return moves + drive.changes();
  }

  /** Others drive with it as one from now on; null: it drives alone. */
  void setFormation(@Nullable FormationFootprint newFormation) {
    formation = newFormation;
    standingArea = areaAt(pose);
    moves++;
  }

  @Nullable FormationFootprint formation() {
    return formation;
  }

  /** What it covers when it is there. */
  SweptArea areaAt(Pose at) {
    return formation == null
        ? SweptArea.at(at.position(), radius)
        : SweptArea.at(formation.discs(at));
  }

  /** What it covers while it drives the segment. */
  SweptArea sweptArea(Pose from, Segment segment) {
    return formation == null
        ? SweptArea.along(from, segment, radius)
        : formation.sweptArea(from, segment);
  }

  /** A segment of its path in pieces that are as slow as the floor wants. */
  List<Segment> limited(Pose from, Segment segment) {
    List<Vec2> members = new ArrayList<>(List.of(Vec2.ZERO));
    if (formation != null) {
      members.addAll(formation.shape().offsets());
    }
    return SpeedLimiter.limited(grid.rules(), members, from, segment);
  }

  /** A section of its path that covers an area. */
  Section section(List<Segment> segments, Pose end, SweptArea area, boolean endsHalfway) {
    return new Section(segments, end, area, areaAt(end), area.cells(grid, 0), endsHalfway);
  }

  /** How it shall face at a point; null: in any heading. */
  @Nullable Double requiredHeadingAt(Vec2 point) {
    return goal != null && goalHeading != null && isAtGoalPoint(point) ? goalHeading : null;
  }

  /** What it covers where it is. */
  SweptArea standingArea() {
    return standingArea;
  }

  /** What is its own now, in parts: where it is, and all of what it may drive. */
  List<SweptArea> allocated() {
    return Allocation.areas(this);
  }

  /** Whether it is there, but for what a robot may be beside its path. */
  boolean isWithin(SweptArea area) {
    return area.gapTo(pose.position()) < Trajectory.MAX_DEVIATION - radius;
  }

  /** The cells that it touches by that, as bits by their index. */
  BitSet allocatedCells() {
    BitSet cells = new BitSet();
    allocated().forEach(area -> area.cells(grid, 0).addTo(cells));
    return cells;
  }

  /** What it has or will need, in parts. */
  List<SweptArea> claimed() {
    List<SweptArea> areas = allocated();
    areas.addAll(drive.unreleasedAreas());
    return areas;
  }

  /** Where it will be when it has driven what it is going to drive anyway, and can go elsewhere. */
  Pose committedEnd() {
    return poseAfter(drive.committed());
  }

  /** Where it will be when it has driven what is released. */
  Pose releasedEnd() {
    return poseAfter(drive.released());
  }

  private Pose poseAfter(int sections) {
    if (drive.path() != null) {
      return drive.path().poseAfter(sections);
    }
    if (formation == null) {
      return pose;
    }
    Pose last = drive.lastPathEnd();
    return last != null && FormationPlanner.isAtPlace(last, pose)
        ? last
        : FormationPlanner.start(grid, pose);
  }

  /** The cell where it is. */
  Cell cell() {
    return grid.cellAt(pose.position());
  }

  Cell committedCell() {
    return grid.cellAt(committedEnd().position());
  }

  boolean isAtGoal() {
    return goal != null && drive.path() == null && isGoal(pose);
  }

  /** Whether who is there is at its goal, or where it fills a cell, in that of its goal. */
  boolean isGoal(Pose place) {
    if (goal == null) {
      return false;
    }
    if (formation != null) {
      Vec2 load = formation.shape().loadAt(place).position();
      return load.distanceTo(goal) < FormationLattice.goalTolerance(grid);
    }
    boolean facesRight =
        goalHeading == null || Math.abs(Angles.difference(place.theta(), goalHeading)) < FACING;
    return facesRight && isAtGoalPoint(place.position());
  }

  private boolean isAtGoalPoint(Vec2 point) {
    Vec2 wanted = Objects.requireNonNull(goal);
    double cell = grid.resolution();
    if (Math.abs(point.x() - wanted.x()) > cell + ARRIVED
        || Math.abs(point.y() - wanted.y()) > cell + ARRIVED) {
      return false; // as for most, which saves the distances
    }
    boolean fillsCell = LaneGrid.side(grid, 2 * radius) == 1;
    double aside = point.distanceTo(grid.centre(grid.cellAt(wanted)));
    return point.distanceTo(wanted) < ARRIVED
        || (fillsCell && aside < Math.max(ARRIVED, NEAR * cell));
  }

  @Nullable Cell goalCell() {
    return goal == null ? null : grid.cellAt(goal);
  }

  /** Wants to go somewhere and has no path there, or only one that ends short of it. */
  boolean needsPath() {
    return goal != null && movable && !drive.hasUncommitted() && !isGoal(committedEnd());
  }

  /** Is on a path that leads it nearer to its goal, but not there. */
  boolean isPlannedAhead() {
    return goal != null && drive.isOnSharedPath() && !hasPathToGoal();
  }

  /** Wants to go somewhere, and is there or on its path there. */
  boolean hasPathToGoal() {
    ReservedPath path = drive.path();
    return goal != null && isGoal(path == null ? pose : path.end());
  }

  /** Waits, and is served first: a formation, which cannot step aside, then who waits longest. */
  boolean hasPrecedenceOver(TrafficRobot other) {
    Instant since = waiting.since();
    if (since == null || isFormation() != other.isFormation()) {
      return since != null && isFormation();
    }
    Instant otherSince = other.waiting.since();
    return otherSince == null || since.isBefore(otherSince);
  }

  boolean isFormation() {
    return formation != null;
  }

  /** Why it does not get on; null while it does. */
  @Nullable WaitReason waitReason() {
    WaitReason reason = waiting.noPathReason();
    if (reason != null) {
      return reason;
    }
    return drive.isDriving() ? null : waiting.blockedReason();
  }

  /** Begins another path where the released part of this one ends. */
  void continueOn(ReservedPath next) {
    drive.continueOn(next);
    waiting.forgetPath();
  }

  /**
   * Begins a path that was planned elsewhere.
   *
   * @param along so many of its sections are the last that it was released
   */
  void adopt(ProposedPath next, int along) {
    drive.adopt(next.path(), along, next.releasedAtOnce(), next.number());
    waiting.forgetPath();
  }

  /** It is stopped and has no path. */
  void stop() {
    drive.stop();
    cutOffBy = null;
    waiting.setBlockedReason(null);
  }

  /** Gives up what is not released. */
  void freeUnreleased() {
    if (drive.freeUnreleased()) {
      waiting.setBlockedReason(null);
    }
  }

  /**
   * It is where a trajectory begins that it drives already, and may drive to its end.
   *
   * @param completedSegments so many are completed
   */
  void adopt(Trajectory trajectory, int completedSegments, Instant now) {
    List<Section> sections = new ArrayList<>();
    Pose at = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      SweptArea area = sweptArea(at, segment);
      at = at.advanced(segment.twist(), segment.t());
      sections.add(section(List.of(segment), at, area, false));
    }
    continueOn(ReservedPath.independent(trajectory.start(), sections));
    drive.resume(completedSegments, now);
  }

  /**
   * What the robot does not know yet of its path, if anything; counts as told from now on.
   *
   * @param commands get that too
   */
  void takeUnsentCommands(List<DriveCommand> commands) {
    ReservedPath path = drive.path();
    if (path == null || !movable) {
      return;
    }
    if (drive.hasChanged()) {
      boolean endsAtGoal = goal == null || isGoal(path.end());
      drive.takeUnsentCommand(name, endsAtGoal).ifPresent(commands::add);
    }
    drive.takeUnsentRoom(name).ifPresent(commands::add); // what is beside it is released before
  }
}
