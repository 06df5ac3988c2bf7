package org.toqa.traffic.floor;

import static java.util.Comparator.nullsLast;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.wording.Sentence;

/**
 * Who may drive where on one floor, and in which order.
 *
 * <p>A robot that wants to go somewhere is first offered its own smooth way: the shortest one in
 * eight headings round whoever stands. It gets it if the cells that it sweeps meet nobody else's,
 * now or later; such ways need no order. Otherwise all robots are planned together from where their
 * released ways end ({@link JointPlanner}), those that want nothing too, so that they step aside;
 * the plan's order of visits to each cell is then kept ({@link JointPlan}).
 *
 * <p>Ways are released stretch by stretch. A stretch is released when no other robot holds a cell
 * of it and whoever comes before has left; what is released is driven to its end whatever others
 * do, and a robot can stand there. So a robot never enters what another has not left, however late
 * anyone is, and since the order has no cycle somebody can always go on.
 *
 * <p>Confined to one thread. It knows no clock: time is handed in.
 *
 * <ol>
 *   <li>Tell it what is so: {@link #reportStanding}, {@link #reportProgress}, {@link #setGoal},
 *       {@link #setMovable}.
 *   <li>Ask {@link #decide} what robots are to be told, in that order.
 * </ol>
 */
public final class FloorTraffic {
  private static final Duration NO_PROGRESS_AFTER = Duration.ofSeconds(10);
  private static final Duration PLAN_AGAIN_AFTER = Duration.ofSeconds(5);
  private static final Duration MAKE_ROOM_AFTER = Duration.ofSeconds(2);
  private static final Duration RETRY_AFTER = Duration.ofSeconds(1);

  private final FreeSpace freeSpace;
  private final SingleRobotPlanner singleRobotPlanner;
  private final LanePlanner lanePlanner;
  private final SectionReleaser releaser;
  private final WaitReasonFinder waitReasons;
  private final CellAllocations allocations;
  private final StandstillDetector standstillDetector = new StandstillDetector();
  private final Map<String, TrafficRobot> robots = new TreeMap<>();
  private int robotCount;

  /** Whether something changed since the robots were last planned together. */
  private boolean changed = true;

  /** Whether a robot gave up a part of its way that others wait for it to drive. */
  private boolean mustReplan;

  /** When any robot last completed a stretch. */
  private Instant lastProgress = Instant.MIN;

  private Instant lastJointPlan = Instant.MIN;

  /**
   * @param planningDeadline how long a plan for all robots may take
   */
  public FloorTraffic(
      OccupancyGrid grid, JointPlanner jointPlanner, Supplier<Deadline> planningDeadline) {
    SectionFitter fitter = new SectionFitter();
    this.freeSpace = new FreeSpace(grid);
    this.singleRobotPlanner = new SingleRobotPlanner(freeSpace, fitter);
    this.lanePlanner =
        new LanePlanner(freeSpace, singleRobotPlanner, fitter, jointPlanner, planningDeadline);
    this.allocations = new CellAllocations(grid, robots.values());
    this.releaser = new SectionReleaser(fitter, robots, allocations);
    this.waitReasons = new WaitReasonFinder(freeSpace, singleRobotPlanner);
  }

  // --- what is so -------------------------------------------------------------------------------

  /** The robot stands at a pose and has no way; it may be new here. */
  public void reportStanding(String robot, Pose pose, double footprint, Instant now) {
    OccupancyGrid grid = freeSpace.grid();
    TrafficRobot m =
        robots.computeIfAbsent(
            robot, name -> new TrafficRobot(name, ++robotCount, grid, pose, footprint / 2, now));
    mustReplan |= m.hasUnreleased();
    changed |= m.path != null || !m.cell().equals(grid.cellAt(pose.position()));
    m.setPose(pose, footprint / 2);
    m.stop();
  }

  /**
   * The robot, which stands, leads others from now on: what it wants is where the load shall go,
   * and all of the group's cells are its own. The others must have left.
   *
   * @param formation null: it drives alone again
   */
  public void setFormation(String robot, @Nullable FormationFootprint formation) {
    TrafficRobot m = robot(robot);
    if (m.formation() != formation) {
      freeUnreleased(m);
      m.setFormation(formation);
      changed = true;
    }
  }

  /**
   * How fast the robot shall drive from now on.
   *
   * @param robot one that stands or drives here
   */
  public void setSpeeds(String robot, DriveSpeeds speeds) {
    robot(robot).speeds = speeds;
  }

  /**
   * The robot is on the way that it was told.
   *
   * @param completedSegments so many are completed
   */
  public void reportProgress(String robot, Pose pose, int completedSegments, Instant now) {
    TrafficRobot m = robot(robot);
    m.setPose(pose, m.radius);
    ReservedPath path = m.path;
    if (path != null) {
      int done = Math.min(path.completedSections(completedSegments), m.released);
      if (done > m.completed) {
        m.completed = done;
        m.lastProgress = now;
        lastProgress = now;
        changed |= done == path.sectionCount();
      }
    }
  }

  /**
   * The robot is known to drive a way that this traffic did not give it, as after a restart.
   *
   * @param trajectory all of which up to {@code released} segments it may drive; the rest is
   *     forgotten
   */
  public void adoptTrajectory(
      String robot,
      Pose pose,
      double footprint,
      Trajectory trajectory,
      int completedSegments,
      int released,
      Instant now) {
    reportStanding(robot, pose, footprint, now);
    TrafficRobot m = robot(robot);
    List<Section> sections = new ArrayList<>();
    Pose at = trajectory.start();
    for (Segment segment :
        trajectory.segments().subList(0, Math.min(released, trajectory.segments().size()))) {
      CellSet cells = m.sweptCells(at, segment);
      at = at.advanced(segment.twist(), segment.t());
      sections.add(new Section(List.of(segment), at, cells, m.cellsAt(at)));
    }
    m.continueOn(ReservedPath.independent(trajectory.start(), sections));
    m.released = sections.size();
    m.completed = Math.min(completedSegments, sections.size());
    m.isDriveStarted = true;
    m.sentReleased = m.released;
    m.lastProgress = now;
  }

  /**
   * @param goal null: it wants nothing, and may be asked to step aside
   */
  public void setGoal(String robot, @Nullable Vec2 goal, Instant now) {
    setGoal(robot, goal, null, now);
  }

  /**
   * @param goal null: it wants nothing, and may be asked to step aside
   * @param heading how it shall face there, radians, map frame; null: in any way
   */
  public void setGoal(String robot, @Nullable Vec2 goal, @Nullable Double heading, Instant now) {
    TrafficRobot m = robot(robot);
    if (!Objects.equals(m.goal, goal) || !Objects.equals(m.goalHeading, heading)) {
      m.goal = goal;
      m.goalHeading = heading;
      m.wantedCells = new BitSet();
      m.waitingSince = goal == null ? null : now;
      m.noPathReason = null;
      m.goalTakenBy = null;
      changed = true;
    }
  }

  /** Says whether it can be told to move; one that is lost, held or not localised cannot. */
  public void setMovable(String robot, boolean movable) {
    TrafficRobot m = robot(robot);
    if (m.movable != movable) {
      m.movable = movable;
      changed = true;
      if (!movable) {
        freeUnreleased(m);
      }
    }
  }

  /**
   * Something stands where the map shows nothing: robots go round, and ways that are not released
   * are given up where they meet it.
   *
   * @param cells all that are obstructed now, as bits by {@link OccupancyGrid#index}; instead of
   *     those told before
   */
  public void setObstacles(BitSet cells) {
    if (freeSpace.setObstacles(cells)) {
      changed = true;
      robots.values().stream().filter(m -> m.hasUnreleasedOn(cells)).forEach(this::freeUnreleased);
    }
  }

  public void removeRobot(String robot) {
    mustReplan |= robot(robot).hasUnreleased();
    robots.remove(robot);
    changed = true;
  }

  public boolean hasRobot(String robot) {
    return robots.containsKey(robot);
  }

  private TrafficRobot robot(String robot) {
    TrafficRobot m = robots.get(robot);
    if (m == null) {
      throw new IllegalArgumentException("There is no robot " + robot + " on this floor.");
    }
    return m;
  }

  // --- what can be read -------------------------------------------------------------------------

  /** Whether the robot stands in the cell it wants. */
  public boolean isAtGoal(String robot) {
    return robot(robot).isAtGoal();
  }

  /** Why it does not go on, for people; null while it does. */
  public @Nullable Sentence waitReason(String robot) {
    WaitReason waitReason = robot(robot).waitReason();
    return waitReason == null ? null : waitReason.sentence();
  }

  /** The cells that are its own now, as bits by {@link OccupancyGrid#index}. */
  public BitSet allocatedCells(String robot) {
    return robot(robot).allocatedCells();
  }

  /** Whether an obstacle stands on what it has been released and not driven yet. */
  public boolean isObstacleAhead(String robot) {
    TrafficRobot m = robot(robot);
    ReservedPath path = m.path;
    return path != null
        && path.sections().subList(Math.min(m.completed, m.released), m.released).stream()
            .anyMatch(section -> section.cells().intersects(freeSpace.obstacles()));
  }

  /** Robots that do not get on as they should, each in one of these at most. */
  public List<Standstill> standstills() {
    return standstillDetector.standstills();
  }

  /** The rest of its way. */
  public RemainingPath remainingPath(String robot) {
    TrafficRobot m = robot(robot);
    return m.path == null
        ? RemainingPath.NONE
        : RemainingPath.of(m.path, m.completed, m.released, m.pose);
  }

  // --- decisions --------------------------------------------------------------------------------

  /** Plans for whoever needs a way, and releases what can be. */
  public List<DriveCommand> decide(Instant now) {
    allocations.refresh();
    detectStalls(now);
    planSingleRobots(now);
    planJointly(now);
    findWaitReasons(now);
    robots.values().stream().filter(m -> m.needsPath()).forEach(m -> makeRoomFor(m, now));
    robots.values().forEach(m -> releaser.release(m, now));
    standstillDetector.update(robots.values(), now);
    return robots.values().stream().flatMap(m -> m.takeUnsentCommand().stream()).toList();
  }

  private void freeUnreleased(TrafficRobot m) {
    mustReplan |= m.hasUnreleased();
    m.freeUnreleased();
  }

  private void detectStalls(Instant now) {
    for (TrafficRobot m : robots.values()) {
      if (!m.isDriving()) {
        m.lastProgress = now;
      }
      boolean stalled = StandstillDetector.isNotMoving(m, now);
      if (stalled != m.stalled) {
        m.stalled = stalled;
        changed = true;
        if (stalled) {
          freeUnreleased(m);
        }
      }
    }
  }

  /** Gives their own ways to those that wait: groups first, then the longest waiting. */
  private void planSingleRobots(Instant now) {
    List<TrafficRobot> unserved =
        robots.values().stream()
            .filter(TrafficRobot::needsPath)
            .sorted(
                Comparator.<TrafficRobot, Boolean>comparing(m -> !m.isFormation())
                    .thenComparing(
                        m -> m.waitingSince, nullsLast(Comparator.<Instant>naturalOrder())))
            .toList();
    for (TrafficRobot m : unserved) {
      if (m.waitingSince == null) {
        m.waitingSince = now;
      }
      if (changed || m.lastSinglePlan.plus(RETRY_AFTER).isBefore(now)) {
        m.lastSinglePlan = now;
        BitSet claimed = claimedByOthers(m);
        robots.values().stream()
            .filter(o -> o.hasPrecedenceOver(m))
            .forEach(o -> claimed.or(o.wantedCells));
        singleRobotPlanner
            .pathAmong(m, robots.values(), claimed)
            .ifPresent(sections -> adoptOwnPath(m, sections));
      }
    }
  }

  private static void adoptOwnPath(TrafficRobot m, List<Section> sections) {
    m.continueOn(ReservedPath.independent(m.releasedEnd(), sections));
    m.noPathReason = null;
    m.goalTakenBy = null;
    m.waitingSince = null;
    m.wantedCells = new BitSet();
  }

  private BitSet claimedByOthers(TrafficRobot m) {
    BitSet claimed = new BitSet();
    for (TrafficRobot other : robots.values()) {
      if (other != m) {
        other.addClaimedTo(claimed);
      }
    }
    return claimed;
  }

  private void planJointly(Instant now) {
    mustReplan |= hasStandstill(now);
    boolean isNeeded = mustReplan || robots.values().stream().anyMatch(TrafficRobot::needsPath);
    if (!isNeeded || !(changed || lastJointPlan.plus(PLAN_AGAIN_AFTER).isBefore(now))) {
      return;
    }
    lastJointPlan = now;
    changed = false;
    if (lanePlanner.plan(robots.values(), allocations, mustReplan) == LanePlanner.Outcome.PLANNED) {
      mustReplan = false;
      for (TrafficRobot m : robots.values()) {
        if (m.hasPathToGoal()) {
          m.noPathReason = null;
          m.waitingSince = null;
        }
      }
    }
  }

  /** Whether robots wait in a circle, or have ways and none has got on for long. */
  private boolean hasStandstill(Instant now) {
    boolean isCycle =
        standstillDetector.standstills().stream()
            .anyMatch(s -> s.kind() == Standstill.Kind.CYCLE_OF_WAITS);
    return isCycle
        || (lastProgress.plus(NO_PROGRESS_AFTER).isBefore(now)
            && robots.values().stream().anyMatch(TrafficRobot::hasUnreleased)
            && robots.values().stream().noneMatch(m -> m.isDriving() && !m.stalled));
  }

  private void findWaitReasons(Instant now) {
    for (TrafficRobot m : robots.values()) {
      if (!m.needsPath()) {
        m.noPathReason = null;
      } else if (m.noPathReason == null || m.noPathReasonFound.plus(RETRY_AFTER).isBefore(now)) {
        m.noPathReason = waitReasons.reasonFor(m, robots.values());
        m.noPathReasonFound = now;
      }
    }
  }

  /**
   * Where a robot stands in another's only way and no plan for all could move it, as one that is
   * too large for the lanes, it is sent to the nearest place where it stands in nobody's way.
   */
  private void makeRoomFor(TrafficRobot m, Instant now) {
    if (m.waitingSince == null || m.waitingSince.plus(MAKE_ROOM_AFTER).isAfter(now)) {
      return;
    }
    TrafficRobot other = robotBlocking(m);
    if (other == null || !other.movable || other.hasPrecedenceOver(m)) {
      return;
    }
    m.wantedCells = new BitSet();
    singleRobotPlanner
        .pathAroundNotMovable(m, robots.values())
        .ifPresent(sections -> sections.forEach(s -> s.cells().addTo(m.wantedCells)));
    if (m.wantedCells.isEmpty()) {
      return;
    }
    singleRobotPlanner
        .pathOutOf(other, robots.values(), claimedByOthers(other), m.wantedCells)
        .ifPresent(
            sections -> {
              freeUnreleased(other);
              other.continueOn(ReservedPath.independent(other.releasedEnd(), sections));
              other.waitingSince = other.goal == null ? null : now;
            });
  }

  /** One that cannot go on its way, as to where a group stands, stands in that group's way too. */
  private @Nullable TrafficRobot robotBlocking(TrafficRobot m) {
    WaitReason reason = m.noPathReason;
    if (reason == null || reason.robot() == null) {
      return null;
    }
    TrafficRobot other = robots.get(reason.robot());
    boolean isStanding =
        switch (reason) {
          case WaitReason.RobotStanding _ -> other != null && other.path == null;
          case WaitReason.RobotPassing _ -> other != null && m.isFormation() && !other.isDriving();
          default -> false;
        };
    return isStanding ? other : null;
  }
}
