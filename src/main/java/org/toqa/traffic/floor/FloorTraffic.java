package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Margins;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.FreeZone;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.lifelong.LifelongPlanner;
import org.toqa.traffic.lifelong.RollingHorizonPlanner;
import org.toqa.wording.Sentence;

/**
 * Who may drive where on one floor, and in which order.
 *
 * <p>A robot that wants to go somewhere is first offered a path of its own: the shortest one in
 * eight headings round stopped robots, or a smooth curve ({@link Moves}). It gets it if the cells
 * that it sweeps meet nobody else's, now or later; such paths need no order. Otherwise all robots
 * are planned together from where their released paths end, those without a goal too, so that they
 * step aside; the plan's order of visits to each cell is then kept ({@link JointPlan}). Few robots
 * are planned whole ({@link JointPlanner}); of many the next steps are, again as they drive on
 * ({@link LifelongPlanner}), and whole only where nobody has got on for long.
 *
 * <p>Paths are released section by section. A section is released when it keeps off all that others
 * have still to drive of what was released to them, and whoever comes before may go on from there;
 * what is released is driven to its end whatever others do, and a robot can be stopped there. So a
 * robot never enters what another has not left, however late anyone is, and since the order has no
 * cycle somebody can always go on.
 *
 * <p>Confined to one thread; paths are planned by another, and adopted when they are ready and
 * still fit. It knows no clock: time is handed in. Points and poses are in the map frame. A robot
 * must be known here, by {@link #reportStanding}, before anything else is said or asked of it: else
 * that is an {@link IllegalArgumentException}.
 *
 * <ol>
 *   <li>Tell it what is so: {@link #reportStanding}, {@link #reportProgress}, {@link #setGoal},
 *       {@link #setMovable}.
 *   <li>Ask {@link #decide} what robots are to be told, in that order.
 * </ol>
 */
public final class FloorTraffic {
  private static final long SEED = 7275;

  private final OccupancyGrid grid;
  private final PathAssigner pathAssigner;
  private final SectionReleaser releaser;
  private final Claims claims;
  private final ManualSteps manualSteps;
  private final RoomLender roomLender;
  private final ZoneLender zoneLender;
  private final StandstillDetector standstillDetector = new StandstillDetector();
  private final WaitChains waitChains = new WaitChains();
  private final ReplanTrigger trigger = new ReplanTrigger();
  private final Map<String, TrafficRobot> robots = new RobotMap<>();
  private Obstacles obstacles = Obstacles.NONE;
  private int robotCount;

  /**
   * Plans at once, on the thread that asks for decisions.
   *
   * @param planningDeadline by when a plan for all robots that begins now is to be ready
   */
  public FloorTraffic(
      OccupancyGrid grid, JointPlanner jointPlanner, Supplier<Deadline> planningDeadline) {
    this(grid, Margins.USUAL, jointPlanner, planningDeadline);
  }

  /** The same with other margins. */
  public FloorTraffic(
      OccupancyGrid grid,
      Margins margins,
      JointPlanner jointPlanner,
      Supplier<Deadline> planningDeadline) {
    this(
        grid,
        margins,
        Moves.HEADING,
        jointPlanner,
        FloorTraffic::rollingPlanner,
        planningDeadline,
        Runnable::run);
  }

  /** A planner of the next steps of robots that keep apart so many cells. */
  public static LifelongPlanner rollingPlanner(double apart) {
    return new RollingHorizonPlanner(MotionModel.TURNS, false, apart, SEED);
  }

  /**
   * @param moves by which robots drive alone
   * @param nextSteps planners of the next steps of robots that keep apart so many cells
   * @param planningDeadline by when a plan for all robots that begins now is to be ready
   * @param planning what plans, one thing at a time
   */
  public FloorTraffic(
      OccupancyGrid grid,
      Margins margins,
      Moves moves,
      JointPlanner jointPlanner,
      DoubleFunction<LifelongPlanner> nextSteps,
      Supplier<Deadline> planningDeadline,
      Executor planning) {
    this.grid = grid;
    this.claims = new Claims(robots.values());
    this.manualSteps = new ManualSteps(grid, margins, claims);
    this.releaser = new SectionReleaser(new SectionFitter(), robots, claims, trigger);
    this.roomLender = new RoomLender(grid, claims, releaser);
    this.zoneLender = new ZoneLender(grid, claims, releaser);
    this.pathAssigner =
        new PathAssigner(
            robots,
            claims,
            trigger,
            new FloorPlanner(grid, margins, moves, jointPlanner, nextSteps, planningDeadline),
            planning);
  }

  // --- what is so -------------------------------------------------------------------------------

  /**
   * The robot is stopped at a pose and has no path; it may be new here, or elsewhere than it was.
   *
   * @param diameter of the disc that the robot fills, metres, above 0
   */
  public void reportStanding(String name, Pose pose, double diameter, Instant now) {
    boolean isNew = !robots.containsKey(name);
    TrafficRobot robot =
        robots.computeIfAbsent(
            name, key -> new TrafficRobot(key, ++robotCount, grid, pose, diameter / 2, now));
    robot.waiting.observe(pose.position(), now);
    trigger.markFreed(robot);
    if (robot.drive.path() != null || !robot.cell().equals(grid.cellAt(pose.position()))) {
      trigger.markChanged();
    }
    List<SweptArea> known = isNew ? List.of() : robot.claimed();
    robot.setPose(pose, diameter / 2);
    robot.stop();
    freePathsThrough(robot, known);
    if (robot.isElsewhere()) {
      cutOffOthers(robot);
    }
  }

  /** Whoever was released what leads too near to where the robot stands must stop. */
  private void cutOffOthers(TrafficRobot robot) {
    SweptArea there = robot.standingArea();
    for (TrafficRobot other : robots.values()) {
      if (other != robot
          && other.drive.isDriving()
          && other.allocated().stream()
              .anyMatch(area -> Clearance.isBroken(other.standingArea(), area, there))) {
        other.cutOff(robot.name);
      }
    }
  }

  /**
   * The robot that stands on what this one may drive, or nearer to that than robots ever come that
   * keep to their paths, as where a person has moved it; until this one has stopped. Both are
   * planned anew then (Ds of CMCT).
   */
  public Optional<String> cutOffBy(String name) {
    return Optional.ofNullable(robot(name).cutOffBy());
  }

  /**
   * The robot covers more than before, as with a load on it, or less: it and those near it are
   * planned anew.
   *
   * @param diameter metres
   */
  public void setDiameter(String name, double diameter) {
    TrafficRobot robot = robot(name);
    if (robot.radius() == diameter / 2) {
      return;
    }
    robot.setPose(robot.pose(), diameter / 2);
    freeUnreleased(robot);
    freePathsNear(robot, List.of(robot.standingArea()));
    trigger.markChanged();
  }

  /** Where nobody expected the robot, the others give up what is not released to them. */
  private void freePathsThrough(TrafficRobot robot, List<SweptArea> known) {
    boolean isExpected = known.stream().anyMatch(robot::isWithin);
    if (!isExpected) {
      freePathsNear(robot, List.of(robot.standingArea()));
    }
  }

  private void freePathsNear(TrafficRobot robot, List<SweptArea> areas) {
    robots.values().stream()
        .filter(other -> other != robot)
        .filter(other -> areas.stream().anyMatch(other.drive::hasUnreleasedNear))
        .forEach(this::freeUnreleased);
  }

  /**
   * The robot, which is stopped, leads others from now on: its goal is where the load shall go, and
   * all of the formation's cells are its own. The others must have left.
   *
   * @param formation null: it drives alone again
   */
  public void setFormation(String name, @Nullable FormationFootprint formation) {
    TrafficRobot robot = robot(name);
    if (robot.formation() != formation) {
      freeUnreleased(robot);
      robot.setFormation(formation);
      trigger.markChanged();
    }
  }

  /**
   * How fast the robot shall drive from now on.
   *
   * @param name of one that is stopped or drives here
   */
  public void setSpeeds(String name, DriveSpeeds speeds) {
    robot(name).setSpeeds(speeds);
  }

  /**
   * The robot is on the path that it was told.
   *
   * @param completedSegments so many of the path's are completed
   */
  public void reportProgress(String name, Pose pose, int completedSegments, Instant now) {
    TrafficRobot robot = robot(name);
    robot.waiting.observe(pose.position(), now);
    robot.setPose(pose, robot.radius());
    if (robot.drive.complete(completedSegments, now)) {
      trigger.recordProgress(now);
      if (robot.drive.isCompleted()) {
        trigger.markChanged();
      }
    }
  }

  /**
   * The robot is known to drive a trajectory that this traffic did not give it, as after a restart.
   *
   * @param diameter of the disc that the robot fills, metres, above 0
   * @param trajectory all of which up to {@code released} segments it may drive; the rest is
   *     forgotten
   * @param completedSegments so many of its segments are completed
   */
  public void adoptTrajectory(
      String name,
      Pose pose,
      double diameter,
      Trajectory trajectory,
      int completedSegments,
      int released,
      Instant now) {
    reportStanding(name, pose, diameter, now);
    int count = Math.min(released, trajectory.segments().size());
    robot(name)
        .adopt(
            new Trajectory(trajectory.start(), trajectory.segments().subList(0, count)),
            completedSegments,
            now);
  }

  /**
   * The robot sees something small on its path, and is lent room beside that to drive round it, if
   * there is any.
   *
   * @param seen points, metres, map frame
   * @return whether it has room now
   */
  public boolean lendRoom(String name, List<Vec2> seen, Instant now) {
    claims.refresh();
    return roomLender.lend(robot(name), seen, obstacles.of(name), now);
  }

  /**
   * Whether the robot, alone and with nothing wider than itself on board, finds its own way through
   * free zones. It is lent them as it comes to them.
   */
  public void setFindsOwnWay(String name, boolean itDoes) {
    robot(name).setFindsOwnWay(itDoes);
  }

  /**
   * The robot did not take the free zone that it was lent, or did not find its way through it: it
   * follows a path there.
   */
  public void giveUpZone(String name) {
    TrafficRobot robot = robot(name);
    LentRoom lent = robot.drive.lentRoom();
    FreeZone zone = lent == null ? null : lent.room().zone();
    if (zone != null) {
      robot.setGivenUp(new Area(new Vec2(zone.x(), zone.y()), zone.width(), zone.height()));
    }
  }

  /** The robot was lent that before, beside the trajectory that it drives. */
  public void adoptRoom(String name, PassingRoom room) {
    TrafficRobot robot = robot(name);
    ReservedPath path = robot.drive.path();
    if (path != null) {
      robot.drive.resumeRoom(RoomLender.lentBefore(robot, path, room));
    }
  }

  /** Whether the robot was lent room that it has not given back. */
  public boolean hasRoom(String name) {
    return robot(name).drive.lentRoom() != null;
  }

  /**
   * The robot is on its path again, and has given its room back. A free zone that it has not driven
   * through it is not lent again on this path.
   */
  public void returnRoom(String name) {
    Drive drive = robot(name).drive;
    LentRoom lent = drive.lentRoom();
    if (lent != null && drive.completedSegments() < lent.room().to()) {
      giveUpZone(name);
    }
    drive.endRoom();
  }

  /**
   * The robot shall go somewhere, in any heading.
   *
   * @param goal metres, map frame; null: nowhere, and it may be asked to step aside
   */
  public void setGoal(String name, @Nullable Vec2 goal, Instant now) {
    setGoal(name, goal, null, now);
  }

  /**
   * The robot shall go somewhere.
   *
   * @param goal metres, map frame; null: nowhere, and it may be asked to step aside
   * @param heading how it shall face there, radians, counter-clockwise from map east; null: in any
   *     heading
   */
  public void setGoal(String name, @Nullable Vec2 goal, @Nullable Double heading, Instant now) {
    if (robot(name).setGoal(goal, heading, now)) {
      trigger.markChanged();
    }
  }

  /** Says whether it can be told to move; one that is lost, held or not localised cannot. */
  public void setMovable(String name, boolean movable) {
    TrafficRobot robot = robot(name);
    if (robot.isMovable() != movable) {
      robot.setMovable(movable);
      trigger.markChanged();
      if (!movable) {
        freeUnreleased(robot);
      }
    }
  }

  /**
   * There is an obstacle where the map shows none: robots go round, and paths that are not released
   * are given up where they meet it.
   *
   * @param cells all that are obstructed now, as bits by {@link OccupancyGrid#index}; instead of
   *     those told before
   * @param passable by robot, those of the cells that do not count for it
   */
  public void setObstacles(BitSet cells, Map<String, BitSet> passable) {
    if (!cells.equals(obstacles.cells()) || !passable.equals(obstacles.passable())) {
      obstacles = new Obstacles((BitSet) cells.clone(), passable);
      trigger.markChanged();
      robots.values().stream()
          .filter(robot -> robot.drive.hasUnreleasedOn(obstacles.of(robot.name)))
          .forEach(this::freeUnreleased);
    }
  }

  public void removeRobot(String name) {
    TrafficRobot robot = robot(name);
    trigger.markFreed(robot);
    claims.remove(robot);
    robots.remove(name);
    trigger.markChanged();
  }

  public boolean hasRobot(String name) {
    return robots.containsKey(name);
  }

  private TrafficRobot robot(String name) {
    TrafficRobot robot = robots.get(name);
    if (robot == null) {
      throw new IllegalArgumentException("There is no robot " + name + " on this floor.");
    }
    return robot;
  }

  /** Whether the robot is stopped at its goal. */
  public boolean isAtGoal(String name) {
    return robot(name).isAtGoal();
  }

  /** Why it does not go on, for people; null while it does. */
  public @Nullable Sentence waitReason(String name) {
    return waitChains.sentence(robot(name));
  }

  /** Where the obstacle is for which it does not go on. */
  public Optional<Vec2> obstacleInTheWay(String name) {
    return robot(name).waitReason() instanceof WaitReason.ObstacleOnPath(Vec2 where)
        ? Optional.of(where)
        : Optional.empty();
  }

  /**
   * The robot that it waits for in the end, where those before it wait themselves, if that one does
   * not go on by itself.
   */
  public Optional<String> blockingRobot(String name) {
    return waitChains.blockingRobot(robot(name));
  }

  /** The cells that are its own now, as bits by {@link OccupancyGrid#index}. */
  public BitSet allocatedCells(String name) {
    return robot(name).allocatedCells();
  }

  /**
   * The robots that have a cell for their own now.
   *
   * @param cell by {@link OccupancyGrid#index}
   */
  public Set<String> robotsAt(int cell) {
    claims.refresh();
    return claims.at(grid, cell).stream().map(robot -> robot.name).collect(Collectors.toSet());
  }

  /** Whether an obstacle is on what it has been released and not driven yet. */
  public boolean isObstacleAhead(String name) {
    return isAhead(name, obstacles.of(name));
  }

  public boolean isAhead(String name, BitSet cells) {
    return robot(name).drive.hasAheadOn(cells);
  }

  /** The cells that it touches as it stands now. */
  public BitSet standingCells(String name) {
    BitSet cells = new BitSet();
    robot(name).standingArea().cells(grid, 0).addTo(cells);
    return cells;
  }

  public Vec2 position(String name) {
    return robot(name).pose().position();
  }

  /** Robots that do not get on as they should, each in one of these at most. */
  public List<Standstill> standstills() {
    return standstillDetector.standstills();
  }

  /** The rest of its path. */
  public RemainingPath remainingPath(String name) {
    TrafficRobot robot = robot(name);
    Drive drive = robot.drive;
    ReservedPath path = drive.path();
    return path == null
        ? RemainingPath.NONE
        : RemainingPath.of(
            drive.behindOpen(),
            robot.pose(),
            drive.openSection().map(open -> PathDeviation.of(open, robot.pose())));
  }

  /**
   * A person drives the robot by hand, and wants it to go on so behind what it may drive. It must
   * not be movable ({@link #setMovable}), so that nothing else is planned for it, and must stand or
   * drive what was granted here. What others were to drive near it, they are planned anew.
   *
   * @param twist vx metres a second, w radians a second; not both 0
   * @param ahead seconds of driving that the robot shall have then, all in all
   */
  public ManualStep takeManualStep(String name, Twist twist, double ahead) {
    TrafficRobot robot = robot(name);
    if (robot.isMovable()) {
      throw new IllegalArgumentException(name + " drives by itself.");
    }
    claims.refresh();
    ManualStep step = manualSteps.take(robot, obstacles, twist, ahead);
    if (step instanceof ManualStep.Granted) {
      freePathsNear(robot, robot.allocated());
    }
    return step;
  }

  /** Has paths planned for whoever needs one, and releases what can be. */
  public List<DriveCommand> decide(Instant now) {
    claims.refresh();
    detectStalls(now);
    pathAssigner.adoptPlan(obstacles, now);
    release(now);
    if (pathAssigner.requestPlan(standstills(), obstacles, now)) {
      pathAssigner.adoptPlan(obstacles, now); // if it is made already
      release(now);
    }
    standstillDetector.update(robots, now);
    waitChains.update(robots);
    List<DriveCommand> commands = new ArrayList<>();
    robots.values().forEach(robot -> robot.takeUnsentCommands(commands));
    return commands;
  }

  /** Whether the plan that is being made was asked for so long ago. */
  public boolean isPlanningFor(Duration time, Instant now) {
    return pathAssigner.isPlanningFor(time, now);
  }

  private void release(Instant now) {
    boolean planned = pathAssigner.isPlanningJointly();
    robots.values().forEach(robot -> release(robot, planned, now));
  }

  private void release(TrafficRobot robot, boolean isPlanned, Instant now) {
    int beforeZone = zoneLender.sectionsBefore(robot, now);
    releaser.release(robot, isPlanned, beforeZone, now);
    if (robot.drive.released() >= beforeZone
        && zoneLender.lend(robot, obstacles.of(robot.name), now)) {
      releaser.release(robot, isPlanned, Integer.MAX_VALUE, now);
    }
  }

  private void freeUnreleased(TrafficRobot robot) {
    trigger.markFreed(robot);
    robot.freeUnreleased();
  }

  private void detectStalls(Instant now) {
    for (TrafficRobot robot : robots.values()) {
      if (!robot.drive.isDriving()) {
        robot.drive.restartProgress(now);
      }
      boolean stalled = StandstillDetector.isNotMoving(robot, now);
      if (stalled != robot.isStalled()) {
        robot.setStalled(stalled);
        trigger.markChanged();
        if (stalled) {
          freeUnreleased(robot);
        }
      }
    }
  }
}
