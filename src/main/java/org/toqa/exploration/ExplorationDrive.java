package org.toqa.exploration;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import org.toqa.exploration.RobotLidar.Scan;
import org.toqa.formation.swarm.LoopMemory;
import org.toqa.formation.swarm.Observers;
import org.toqa.formation.swarm.ShapeKeeping;
import org.toqa.formation.swarm.Sightings;
import org.toqa.formation.swarm.SwarmLaw;
import org.toqa.formation.swarm.SwarmRobot;
import org.toqa.formation.swarm.Turn;
import org.toqa.formation.swarm.VirtualLeader;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;

/**
 * A swarm of simulated robots, or one, drives over ground that it knows nothing of.
 *
 * <p>In each step of {@link #STEP}: the observers' lidars read, which goes into the map that all
 * share ({@link EvidenceGrid}); the swarm's law ({@link SwarmLaw}) turns all by what the observers
 * see, else toward where the way leads; all drive on, and back to their places in the shape.
 *
 * <p>The published law drives straight to the target, and neither leaves every loop nor keeps every
 * robot ({@code docs/laboratory.md}). Three things are added, by the map that the swarm has:
 *
 * <ul>
 *   <li>Toward the target is toward the last point in sight of the shortest way there, with all
 *       that is unknown taken for free (Koenig and Likhachev, "D* Lite", AAAI 2002: the freespace
 *       assumption). Where there is no such way, there is none at all for a swarm of that width.
 *   <li>A step that would bring a robot to what was seen is not driven: all turn that way on the
 *       spot.
 *   <li>Where the swarm comes to a place again ({@link LoopMemory}) it drives that way for a while,
 *       whatever the observers see.
 * </ul>
 *
 * <p>Where robots are they know exactly; what they drive has an error of 2 percent of a step. A
 * robot that touches something in truth stands for good, and the others go on. One thread at a
 * time.
 */
public final class ExplorationDrive {
  /** Seconds. */
  public static final double STEP = 0.2;

  /** Metres, of each robot. */
  public static final double ROBOT_RADIUS = 0.25;

  /** Metres along a side of the map's cells. */
  public static final double RESOLUTION = 0.1;

  /** Larger ground is not simulated: about 100 m by 100 m. */
  private static final int MOST_CELLS = 1 << 20;

  /** Cells of the ground itself: such ground in cells of 0.05 m. */
  private static final int MOST_TRUE_CELLS = 4 * MOST_CELLS;

  private static final double SPEED = 0.4;
  private static final double TURN_STEP = Math.toRadians(15);

  /** Metres from a robot's middle at which its lidar sees an obstacle, as the law means it. */
  private static final double LOOKAHEAD = 0.8;

  private static final double OUTWARD = Math.toRadians(20);
  private static final double VIEW = Math.toRadians(30);

  /** Metres between neighbours in the shape. */
  private static final double APART = 0.7;

  /** Metres that are kept from what was seen, by the way and by each step. */
  private static final double MARGIN = 0.05;

  private static final double STEP_MARGIN = 0.03;

  private static final double ACTUATOR_NOISE = 0.02;

  /** Metres from the target within which the leader is there. */
  private static final double THERE = 0.3;

  private static final double MEMORY_SQUARE = 0.5;
  private static final double TRACK = 0.3;

  /** Steps after which the way is looked for anew. */
  private static final int PLAN_STEPS = 5;

  /** Cells of the way among which the farthest in sight is looked for. */
  private static final int SIGHT_CELLS = 40;

  /** Cells about the leader among which a way may begin. */
  private static final int BEGIN_CELLS = 5;

  /** An hour of driving. */
  private static final int MOST_STEPS = 18_000;

  /** How a drive goes on. */
  public enum State {
    DRIVING,
    REACHED,
    /** What was seen leaves a swarm of that width no way to the target. */
    NO_WAY,
    /** All robots have touched something. */
    LOST,
    OUT_OF_TIME
  }

  private final OccupancyGrid truth;
  private final Vec2 target;
  private final double width;
  private final RandomGenerator random;
  private final EvidenceGrid map;
  private final SwarmLaw law = SwarmLaw.published(TURN_STEP);
  private final ShapeKeeping keeping = new ShapeKeeping(0.2, 0.5, 0);
  private final PathPlanner planner = new JumpPointSearch();
  private final List<Vec2> track = new ArrayList<>();

  private List<SwarmRobot> robots;
  private Observers observers;
  private SwarmLaw.Motion motion;
  private LoopMemory memory = LoopMemory.empty(MEMORY_SQUARE);
  private @Nullable OccupancyGrid passable;
  private List<Vec2> way = List.of();
  private double remaining;
  private double driven;
  private int steps;
  private State state = State.DRIVING;

  /**
   * @param truth the ground as it is
   * @throws IllegalArgumentException {@link #fits} says no
   */
  public ExplorationDrive(OccupancyGrid truth, ExplorationOrder order) {
    if (!fits(truth, order)) {
      throw new IllegalArgumentException("There is no room for the swarm at " + order.start());
    }
    this.truth = truth;
    this.target = order.target();
    this.random = new SplittableRandom(order.seed());
    this.map =
        new EvidenceGrid(
            cells(truth.width(), truth), cells(truth.height(), truth), RESOLUTION, truth.origin());
    List<Vec2> places = places(order.robots());
    this.width = width(order.robots());
    this.robots =
        places.stream().map(place -> new SwarmRobot(order.start().plus(place), place)).toList();
    this.motion = SwarmLaw.Motion.straight(target.minus(order.start()).angle());
    this.observers = Observers.of(robots, motion.direction(), 2 * ROBOT_RADIUS);
    this.remaining = order.start().distanceTo(target);
    track.add(order.start());
    robots.forEach(robot -> look(robot).addTo(map)); // once, all look round
  }

  private static int cells(int count, OccupancyGrid truth) {
    return (int) Math.ceil(count * truth.resolution() / RESOLUTION - 1e-9);
  }

  /** Whether ground is not too large, nor its cells too small. */
  public static boolean isSimulated(OccupancyGrid truth) {
    double cells = (double) truth.width() * truth.height();
    return cells <= MOST_TRUE_CELLS
        && cells * Math.pow(truth.resolution() / RESOLUTION, 2) <= MOST_CELLS;
  }

  /** Whether the swarm has room where it starts. */
  public static boolean fits(OccupancyGrid truth, ExplorationOrder order) {
    return new Disc(width(order.robots())).isFreeAt(truth, order.start());
  }

  /** Metres from the swarm's middle to its rim, with what is kept free round it. */
  private static double width(int robots) {
    double farthest = places(robots).stream().mapToDouble(Vec2::norm).max().orElseThrow();
    return farthest + ROBOT_RADIUS + MARGIN;
  }

  /** The robots' places from the leader: rows of a square, about their middle. */
  private static List<Vec2> places(int robots) {
    int row = (int) Math.ceil(Math.sqrt(robots));
    List<Vec2> places = new ArrayList<>();
    Vec2 middle = Vec2.ZERO;
    for (int i = 0; i < robots; i++) {
      int rank = i / row;
      Vec2 place = new Vec2(rank, i % row).times(APART);
      places.add(place);
      middle = middle.plus(place.times(1.0 / robots));
    }
    Vec2 centre = middle;
    return places.stream().map(place -> place.minus(centre)).toList();
  }

  /** Drives one step, if the drive is not over. */
  public State step() {
    if (state == State.DRIVING) {
      state = next();
    }
    return state;
  }

  private State next() {
    Vec2 leader = VirtualLeader.position(robots);
    observers = Observers.of(robots, motion.direction(), 2 * ROBOT_RADIUS);
    Sightings seen = look();
    if (leader.distanceTo(target) <= THERE) {
      remaining = 0;
      return State.REACHED;
    }
    if (steps >= MOST_STEPS) {
      return State.OUT_OF_TIME;
    }
    OccupancyGrid known = map.optimistic();
    if (steps % PLAN_STEPS == 0 && !plan(known, leader)) {
      return State.NO_WAY;
    }
    steps++;
    Vec2 toward = inSight(leader).minus(leader);
    double moved = turn(known, seen, toward) ? SPEED * STEP : 0;
    memory = memory.next(leader, motion.direction(), moved);
    if (moved > 0) {
      robots = moved(leader, new Vec2(moved, 0).rotated(motion.direction()));
      driven += moved;
    }
    if (robots.isEmpty()) {
      return State.LOST;
    }
    if (track.getLast().distanceTo(leader) >= TRACK) {
      track.add(leader);
    }
    return State.DRIVING;
  }

  /** The observers' lidars read; what they see goes into the map. */
  private Sightings look() {
    return new Sightings(
        sees(observers.left(), OUTWARD),
        sees(observers.middle(), 0),
        sees(observers.right(), -OUTWARD));
  }

  private boolean sees(OptionalInt observer, double outward) {
    if (observer.isEmpty()) {
      return false;
    }
    Scan scan = look(robots.get(observer.getAsInt()));
    scan.addTo(map);
    return scan.nearest(motion.direction() + outward, VIEW) < LOOKAHEAD;
  }

  private Scan look(SwarmRobot robot) {
    return RobotLidar.scan(truth, robot.position(), random);
  }

  /** Looks for the way by what is known; false: there is none. */
  private boolean plan(OccupancyGrid known, Vec2 leader) {
    OccupancyGrid inflated = Inflation.inflate(known, width);
    passable = inflated;
    Cell goal = inflated.cellAt(target);
    // drifting, or by the noise of ranges, the leader may be nearer to a wall than the way keeps
    List<Cell> begins =
        inflated.cellsAround(leader, BEGIN_CELLS).stream().filter(inflated::isFree).toList();
    if (begins.isEmpty()
        || !(planner.plan(inflated, begins.getFirst(), goal)
            instanceof PlanResult.Found(var path))) {
      return false;
    }
    way = path.cells().stream().map(inflated::centre).toList();
    remaining = path.cost() * RESOLUTION;
    return true;
  }

  /** The farthest point of the way to which it is free in a straight line. */
  private Vec2 inSight(Vec2 leader) {
    int nearest = 0;
    for (int i = 1; i < way.size(); i++) {
      nearest = leader.distanceTo(way.get(i)) <= leader.distanceTo(way.get(nearest)) ? i : nearest;
    }
    OccupancyGrid grid = passable;
    for (int i = Math.min(way.size() - 1, nearest + SIGHT_CELLS); i > nearest + 1; i--) {
      Vec2 to = way.get(i).minus(leader);
      if (grid != null && RayCast.distance(grid, leader, to.angle(), to.norm()) >= to.norm()) {
        return i == way.size() - 1 ? target : way.get(i);
      }
    }
    return way.get(Math.min(way.size() - 1, nearest + 1));
  }

  /**
   * Turns all.
   *
   * @return whether they drive on, or have turned on the spot
   */
  private boolean turn(OccupancyGrid known, Sightings seen, Vec2 toward) {
    if (!memory.isDetour()) {
      SwarmLaw.Motion byLaw = law.next(motion, seen, toward, random);
      if (isFree(known, byLaw.direction())) {
        motion = byLaw;
        return true;
      }
    }
    double off = Angles.difference(motion.direction(), toward.angle());
    double turned = Math.clamp(off, -TURN_STEP, TURN_STEP);
    motion =
        new SwarmLaw.Motion(
            Angles.normalise(motion.direction() + turned),
            turned > 0 ? Turn.LEFT : turned < 0 ? Turn.RIGHT : Turn.STRAIGHT);
    return isFree(known, motion.direction());
  }

  /** Whether a step in that direction keeps all robots from what was seen. */
  private boolean isFree(OccupancyGrid known, double direction) {
    Vec2 step = new Vec2(SPEED * STEP, 0).rotated(direction);
    Disc disc = new Disc(ROBOT_RADIUS + STEP_MARGIN);
    return robots.stream().allMatch(r -> disc.isFreeAt(known, r.position().plus(step)));
  }

  private List<SwarmRobot> moved(Vec2 leader, Vec2 forward) {
    Disc disc = new Disc(ROBOT_RADIUS);
    List<SwarmRobot> left = new ArrayList<>(robots.size());
    for (SwarmRobot robot : robots) {
      Vec2 slip =
          new Vec2(random.nextGaussian(), random.nextGaussian())
              .times(ACTUATOR_NOISE * forward.norm());
      Vec2 position =
          robot.position().plus(keeping.displacement(robot, leader, forward, Vec2.ZERO)).plus(slip);
      if (disc.isFreeAt(truth, position)) {
        left.add(new SwarmRobot(position, robot.wanted()));
      }
    }
    return left;
  }

  /** How far it is. */
  public ExplorationPicture picture() {
    List<ExplorationPicture.Robot> shown = new ArrayList<>();
    for (int i = 0; i < robots.size(); i++) {
      shown.add(new ExplorationPicture.Robot(robots.get(i).position(), isObserver(i)));
    }
    return new ExplorationPicture(steps * STEP, driven, remaining, shown, track, map.seen());
  }

  private boolean isObserver(int robot) {
    return List.of(observers.left(), observers.middle(), observers.right()).stream()
        .anyMatch(one -> one.isPresent() && one.getAsInt() == robot);
  }
}
