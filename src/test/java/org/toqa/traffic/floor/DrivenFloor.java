package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Queue;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Margins;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.LacamJointPlanner;

/**
 * Drives discs, and groups of them, over a floor exactly as they are told, each as late as chance
 * will have it, and looks on: no two discs may ever overlap, none may touch a wall, none may drive
 * what was not released, none may drive in an area otherwise than is drawn there. It shares nothing
 * with the traffic but its decisions.
 */
final class DrivenFloor {
  /** Who moves for so long goes to and fro, as some do behind one that stays. */
  private static final Duration LONGEST_MOVES = Duration.ofMinutes(30);

  static final double DIAMETER = 0.255;

  /** The side of a cell, metres: robots in the middles of two keep their distance. */
  static final double CELL = 0.4;

  private static final double STEP = 0.1;

  private static final Duration PLANNING_LIMIT = Duration.ofSeconds(2);

  /** What planning is taken to last from one look at the time to the next, on every machine. */
  private static final long NANOS_A_LOOK = 1_000;

  private static final Pattern WAITING_FOR =
      Pattern.compile("^Waiting for (\\w+)( to leave the goal|, which stays at its goal)?");

  private static final String NO_PATH = "Waiting: the map has no path";

  final OccupancyGrid grid;
  final FloorTraffic traffic;
  final Map<String, DrivenBody> bodies = new TreeMap<>();

  /** Whether one was ever put where nobody expected it. */
  private boolean isAnyCarried;

  private int cutOffs;
  final Set<String> lost = new TreeSet<>();
  private final SplittableRandom chance;
  private final AtomicLong looks = new AtomicLong();
  private final AreaJudge areas;
  Instant now = Instant.EPOCH;

  /** So far from where they take themselves to be robots may really be, metres. */
  double mostError;

  /** Plans that are being made. */
  private final Queue<DuePlan> plans = new ArrayDeque<>();

  private record DuePlan(Instant due, Runnable planning) {}

  /** Plans take no time. */
  DrivenFloor(OccupancyGrid grid, long seed) {
    this(grid, seed, Duration.ZERO);
  }

  /** The same by such moves. */
  DrivenFloor(OccupancyGrid grid, Moves moves, long seed) {
    this(grid, moves, seed, Duration.ZERO, PLANNING_LIMIT);
  }

  /** Each plan takes a time of its own. */
  DrivenFloor(OccupancyGrid grid, long seed, Duration mostPlanning) {
    this(grid, seed, mostPlanning, PLANNING_LIMIT);
  }

  /**
   * @param mostPlanning each plan takes a time of its own, up to that
   * @param planningLimit what planning all robots together may look for; see {@link #NANOS_A_LOOK}
   */
  DrivenFloor(OccupancyGrid grid, long seed, Duration mostPlanning, Duration planningLimit) {
    this(grid, Moves.HEADING, seed, mostPlanning, planningLimit);
  }

  private DrivenFloor(
      OccupancyGrid grid, Moves moves, long seed, Duration mostPlanning, Duration planningLimit) {
    this.grid = grid;
    this.areas = new AreaJudge(grid.rules());
    this.chance = new SplittableRandom(seed);
    SplittableRandom delays = new SplittableRandom(seed + 1);
    this.traffic =
        new FloorTraffic(
            grid,
            Margins.USUAL,
            moves,
            new LacamJointPlanner(),
            FloorTraffic::rollingPlanner,
            () -> Deadline.in(planningLimit, this::planningNanos),
            planning -> plan(planning, delays.nextLong(mostPlanning.toMillis() + 1)));
  }

  private void plan(Runnable planning, long millis) {
    if (millis == 0) {
      planning.run();
    } else {
      plans.add(new DuePlan(now.plusMillis(millis), planning));
    }
  }

  private void makePlans() {
    for (DuePlan plan = plans.peek(); plan != null && !plan.due().isAfter(now); ) {
      plans.remove();
      plan.planning().run();
      plan = plans.peek();
    }
  }

  private long planningNanos() {
    return looks.incrementAndGet() * NANOS_A_LOOK;
  }

  /** A floor drawn in text, cells of {@link #CELL}: '#' a wall, anything else free. */
  static OccupancyGrid draw(String... rows) {
    String[] walls = new String[rows.length];
    for (int i = 0; i < rows.length; i++) {
      walls[i] = rows[i].replaceAll("[^#]", ".");
    }
    OccupancyGrid unit = OccupancyGrid.parse(walls);
    return new OccupancyGrid(unit.width(), unit.height(), CELL, Vec2.ZERO, unit.occupied());
  }

  DrivenBody body(String robot) {
    return Objects.requireNonNull(bodies.get(robot), robot);
  }

  void put(String robot, Cell cell) {
    put(robot, cell, DIAMETER);
  }

  void put(String robot, Cell cell, double diameter) {
    putAt(robot, grid.centre(cell), diameter);
  }

  void putAt(String robot, Vec2 p, double diameter) {
    putAt(robot, new Pose(p.x(), p.y(), 0), diameter);
  }

  void putAt(String robot, Pose pose, double diameter) {
    DrivenBody body = new DrivenBody(pose, diameter);
    bodies.put(robot, body);
    areas.put(robot, pose.position());
    traffic.reportStanding(robot, body.pose, diameter, now);
    traffic.setMovable(robot, true);
  }

  /** It drives no faster than that from now on, metres a second. */
  void setMaxSpeed(String robot, double maxSpeed) {
    body(robot).maxSpeed = maxSpeed;
    traffic.setSpeeds(robot, DriveSpeeds.DEFAULT.atMost(maxSpeed, 3.5));
  }

  /** It leads a group from now on; its goals are where the load shall come. */
  void lead(String robot, FormationFootprint group) {
    body(robot).group = group;
    areas.put(robot, body(robot).carries());
    traffic.setFormation(robot, group);
  }

  void send(String robot, @Nullable Cell goal) {
    sendTo(robot, goal == null ? null : grid.centre(goal));
  }

  void sendTo(String robot, @Nullable Vec2 to) {
    body(robot).goal = to;
    traffic.setGoal(robot, to, now);
  }

  void remove(String robot) {
    bodies.remove(robot);
    traffic.removeRobot(robot);
  }

  /** A person carries it there, stopped; who is cut off by that stops. */
  void carry(String robot, Cell cell) {
    DrivenBody body = body(robot);
    body.trajectory = null;
    body.pose = new Pose(grid.centre(cell).x(), grid.centre(cell).y(), 0);
    areas.put(robot, body.pose.position());
    isAnyCarried = true;
  }

  /** How many were stopped since another one stood where they were to drive. */
  int cutOffs() {
    return cutOffs;
  }

  private void stopWhoIsCutOff() {
    bodies.forEach(
        (name, body) -> {
          if (body.trajectory != null && traffic.cutOffBy(name).isPresent()) {
            require(isAnyCarried, name + " is cut off by " + traffic.cutOffBy(name));
            cutOffs++;
            body.trajectory = null;
          }
        });
  }

  /** It stops where it is and wants nothing any more, as after a cancel or a restart. */
  void giveUp(String robot) {
    body(robot).trajectory = null;
    send(robot, null);
  }

  /** It cannot be told anything; it drives to the end of what it was told. */
  void lose(String robot) {
    lost.add(robot);
    traffic.setMovable(robot, false);
  }

  void find(String robot) {
    lost.remove(robot);
    traffic.setMovable(robot, true);
  }

  /**
   * It brakes in the middle of what it was told and forgets it, as when its program was killed, and
   * has come to stand beside it as far as the walls let it.
   *
   * @param metres beside it, at most
   * @param radians askew, at most
   */
  void stopBesidePath(String robot, double metres, double radians) {
    DrivenBody body = body(robot);
    body.trajectory = null;
    isAnyCarried |= metres > Trajectory.MAX_DEVIATION;
    Pose onPath = body.pose;
    for (int tries = 0; tries < 20; tries++) {
      body.pose =
          onPath.compose(
              new Pose(
                  chance.nextDouble(-metres, metres),
                  chance.nextDouble(-metres, metres),
                  chance.nextDouble(-radians, radians)));
      if (body.discs().stream().allMatch(this::isOffTheWalls)) {
        areas.put(robot, body.pose.position());
        return;
      }
    }
    body.pose = onPath;
    areas.put(robot, onPath.position());
  }

  boolean isAt(String robot, Cell cell) {
    DrivenBody body = body(robot);
    return body.trajectory == null && body.pose.position().distanceTo(grid.centre(cell)) < 1e-3;
  }

  boolean isArrived(String robot) {
    DrivenBody body = body(robot);
    return body.goal == null
        || (body.trajectory == null && body.carries().distanceTo(body.goal) < body.arrived(grid));
  }

  boolean areAllArrived() {
    return bodies.keySet().stream().allMatch(this::isArrived);
  }

  /** Lets time go on until all have arrived, or the limit. */
  void drive(Duration limit) {
    Instant end = now.plus(limit);
    while (now.isBefore(end) && !areAllArrived()) {
      step();
    }
  }

  /** Lets time go on until all have arrived, nobody has moved for so long, or half an hour. */
  void driveWhileAnyMoves(Duration patience) {
    Instant end = now.plus(LONGEST_MOVES);
    Instant moved = now;
    List<Pose> before = List.of();
    while (!areAllArrived() && moved.plus(patience).isAfter(now) && now.isBefore(end)) {
      step();
      List<Pose> poses = bodies.values().stream().map(b -> b.pose).toList();
      moved = poses.equals(before) ? moved : now;
      before = poses;
    }
  }

  void step() {
    now = now.plusMillis((long) (STEP * 1000));
    makePlans();
    bodies.forEach(this::report);
    stopWhoIsCutOff();
    traffic.decide(now).forEach(this::obey);
    bodies.values().forEach(body -> body.move(STEP, chance));
    if (mostError > 0) {
      bodies.values().forEach(body -> body.drift(mostError, chance));
    }
    check();
  }

  private void report(String name, DrivenBody body) {
    if (body.trajectory == null) {
      traffic.reportStanding(name, body.pose, body.diameter, now);
    } else {
      traffic.reportProgress(name, body.place(), body.completed, now);
      if (body.isRoomTaken && body.room == null) {
        traffic.returnRoom(name);
        body.isRoomTaken = false;
      }
    }
  }

  private void obey(DriveCommand decision) {
    body(decision.robot()).obey(decision);
  }

  private void check() {
    bodies.forEach((name, body) -> areas.look(name, body.carries(), STEP));
    List<String> names = new ArrayList<>(bodies.keySet());
    for (int i = 0; i < names.size(); i++) {
      DrivenBody a = body(names.get(i));
      if (!a.discs().stream().allMatch(this::isOffTheWalls)) {
        throw new AssertionError(names.get(i) + " touches a wall at " + a.pose);
      }
      for (String other : names.subList(i + 1, names.size())) {
        DrivenBody b = body(other);
        if (a.mayTouch(b) && gap(a, b) <= -1e-6) {
          String pair = names.get(i) + " and " + other;
          throw new AssertionError(pair + " overlap at " + a.pose + ", " + b.pose + " at " + now);
        }
      }
    }
  }

  private static double gap(DrivenBody a, DrivenBody b) {
    return a.discs().stream()
        .flatMapToDouble(
            one ->
                b.discs().stream()
                    .mapToDouble(
                        two -> one.centre().distanceTo(two.centre()) - one.radius() - two.radius()))
        .min()
        .orElseThrow();
  }

  boolean isOffTheWalls(PlacedDisc disc) {
    double r = disc.radius() - 1e-6;
    Cell middle = grid.cellAt(disc.centre());
    int reach = (int) Math.ceil(r / grid.resolution());
    for (int row = middle.row() - reach; row <= middle.row() + reach; row++) {
      for (int column = middle.column() - reach; column <= middle.column() + reach; column++) {
        Cell cell = new Cell(column, row);
        if (!grid.isFree(cell)) {
          Vec2 d = disc.centre().minus(grid.centre(cell));
          double dx = Math.max(0, Math.abs(d.x()) - grid.resolution() / 2);
          double dy = Math.max(0, Math.abs(d.y()) - grid.resolution() / 2);
          if (Math.hypot(dx, dy) < r) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** What a robot says that has not arrived. */
  String reason(String robot) {
    return String.valueOf(traffic.waitReason(robot));
  }

  /**
   * Whether those that the robot waits for, and those that these wait for, end with one that cannot
   * be told to go: it is lost, has no path, or stands at the goal of another. Robots that wait for
   * each other do not.
   */
  boolean waitsForOneThatStays(String robot) {
    Set<String> chain = new TreeSet<>();
    String at = robot;
    while (chain.add(at)) {
      if (lost.contains(at) || reason(at).startsWith(NO_PATH)) {
        return true;
      }
      Matcher waiting = WAITING_FOR.matcher(reason(at));
      if (!waiting.find()) {
        return false;
      }
      at = waiting.group(1);
      if (isArrived(at) && waiting.group(2) != null) {
        return true;
      }
    }
    return false;
  }

  /** What each robot that has not arrived says. */
  Map<String, String> reasons() {
    Map<String, String> reasons = new HashMap<>();
    for (String robot : bodies.keySet()) {
      DrivenBody body = body(robot);
      if (!isArrived(robot) || body.trajectory != null) {
        reasons.put(robot, reason(robot) + " at " + body.pose + " for " + body.goal);
      }
    }
    return reasons;
  }

  static void require(boolean holds, String sentence) {
    if (!holds) {
      throw new AssertionError(sentence);
    }
  }
}
