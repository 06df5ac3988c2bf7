package org.toqa.lab.swarm;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import org.toqa.formation.swarm.LoopMemory;
import org.toqa.formation.swarm.Observers;
import org.toqa.formation.swarm.ShapeKeeping;
import org.toqa.formation.swarm.Sightings;
import org.toqa.formation.swarm.SwarmLaw;
import org.toqa.formation.swarm.SwarmRobot;
import org.toqa.formation.swarm.Turn;
import org.toqa.formation.swarm.VirtualLeader;
import org.toqa.geometry.Vec2;
import org.toqa.grid.RayCast;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Colour;

/**
 * Drives a swarm over a map, a step a second. A robot that touches an obstacle stands for good and
 * is no longer of the swarm; it is in nobody's way, of which the paper says nothing.
 */
final class SwarmDrive {
  /** Seconds. */
  static final double STEP = 1;

  /** Directions in which a robot feels for what is near it. */
  private static final int FEELERS = 8;

  /** Radians between a lidar's rays, at most. */
  private static final double BETWEEN_RAYS = Math.toRadians(10);

  /** Readings are off by so many standard deviations at most. */
  private static final double MOST_DEVIATIONS = 4;

  /** Metres between two points of the track that is drawn. */
  private static final double TRACK = 10;

  /** A drive ends when it has become longer than the straight line, so many times. */
  static final double LONGEST = 6;

  private final SwarmMap map;
  private final SwarmSetup setup;
  private final SwarmLaw law;
  private final double speed;
  private final RandomGenerator random;

  SwarmDrive(SwarmMap map, SwarmSetup setup, SwarmLaw law, double speed, RandomGenerator random) {
    this.map = map;
    this.setup = setup;
    this.law = law;
    this.speed = speed;
    this.random = random;
  }

  /**
   * A drive.
   *
   * @param isReached whether the leader came to the target with robots left
   * @param steps it took
   * @param lost robots that touched an obstacle
   * @param shapeError metres, RMS distance of the robots from their places, at the end
   * @param shapeErrors the same over the drive
   * @param track of the virtual leader
   */
  record Result(
      boolean isReached,
      int steps,
      int lost,
      double shapeError,
      List<Double> shapeErrors,
      List<Vec2> track) {}

  /** A drive on a way of {@link #LONGEST} times the straight line at most. */
  Result run() {
    return run(mostSteps());
  }

  /** A drive of at most so many steps. */
  Result run(int mostSteps) {
    return run(mostSteps, robots -> {});
  }

  private int mostSteps() {
    return (int) (LONGEST * SwarmMap.START.distanceTo(SwarmMap.TARGET) / speed);
  }

  /** The robots of one drive, each where it was at each step; lost ones stand where they were. */
  List<Animation.Body> bodies() {
    Map<Vec2, List<Vec2>> tracks = new LinkedHashMap<>();
    run(
        mostSteps(),
        robots ->
            robots.forEach(
                robot ->
                    tracks
                        .computeIfAbsent(robot.wanted(), place -> new ArrayList<>())
                        .add(robot.position())));
    return tracks.values().stream()
        .map(track -> new Animation.Body("robot", setup.robotRadius(), Colour.PURPLE, track))
        .toList();
  }

  /**
   * @param observer is shown the robots that are left, before each step
   */
  private Result run(int mostSteps, Consumer<List<SwarmRobot>> observer) {
    List<SwarmRobot> robots = new ArrayList<>();
    for (Vec2 place : setup.places()) {
      robots.add(new SwarmRobot(SwarmMap.START.plus(place), place));
    }
    int first = robots.size();
    SwarmLaw.Motion motion =
        SwarmLaw.Motion.straight(SwarmMap.TARGET.minus(SwarmMap.START).angle());
    Deque<Sightings> late = new ArrayDeque<>();
    LoopMemory memory = LoopMemory.empty(setup.lidarRange() / 2);
    List<Vec2> track = new ArrayList<>(List.of(SwarmMap.START));
    List<Double> errors = new ArrayList<>();
    SwarmMap changed = setup.changed(map);
    SwarmMap now = map;
    for (int step = 0; step < mostSteps; step++) {
      observer.accept(robots);
      Vec2 leader = VirtualLeader.position(robots);
      if (track.getLast().distanceTo(leader) >= TRACK) {
        track.add(leader);
        errors.add(VirtualLeader.shapeError(robots));
      }
      if (leader.distanceTo(SwarmMap.TARGET) <= setup.targetRadius()) {
        return result(true, step, first, robots, errors, track);
      }
      now = leader.x() > SwarmSetup.CHANGE_AT ? changed : now;
      late.addLast(seen(now, robots, motion.direction()));
      Sightings known =
          late.size() > setup.delay() ? late.removeFirst() : new Sightings(false, false, false);
      motion = next(motion, known, SwarmMap.TARGET.minus(leader), memory);
      memory = setup.hasMemory() ? memory.next(leader, motion.direction(), speed) : memory;
      robots = moved(now, robots, leader, new Vec2(speed, 0).rotated(motion.direction()));
      if (robots.isEmpty()) {
        return result(false, step, first, robots, errors, track);
      }
    }
    return result(false, mostSteps, first, robots, errors, track);
  }

  private static Result result(
      boolean isReached,
      int steps,
      int first,
      List<SwarmRobot> robots,
      List<Double> errors,
      List<Vec2> track) {
    double error = robots.isEmpty() ? Double.NaN : VirtualLeader.shapeError(robots);
    return new Result(isReached, steps, first - robots.size(), error, errors, track);
  }

  private SwarmLaw.Motion next(
      SwarmLaw.Motion motion, Sightings known, Vec2 toTarget, LoopMemory memory) {
    if (memory.isDetour() && !known.any()) {
      return new SwarmLaw.Motion(motion.direction(), Turn.STRAIGHT);
    }
    return law.next(motion, known, toTarget, random);
  }

  private Sightings seen(SwarmMap now, List<SwarmRobot> robots, double direction) {
    Observers observers = Observers.of(robots, direction, 2 * setup.robotRadius());
    return new Sightings(
        sees(now, robots, observers.left(), direction + setup.outward()),
        sees(now, robots, observers.middle(), direction),
        sees(now, robots, observers.right(), direction - setup.outward()));
  }

  private boolean sees(
      SwarmMap now, List<SwarmRobot> robots, OptionalInt observer, double direction) {
    if (observer.isEmpty()) {
      return false;
    }
    Vec2 from = robots.get(observer.getAsInt()).position();
    int rays = (int) Math.ceil(setup.view() / BETWEEN_RAYS);
    for (int i = -rays; i <= rays; i++) {
      double aside = rays == 0 ? 0 : setup.view() * i / rays;
      if (isRead(now, from, direction + aside)) {
        return true;
      }
    }
    return false;
  }

  /** Whether a ray reads less than the range; with noise it may, of a thing that is farther. */
  private boolean isRead(SwarmMap now, Vec2 from, double direction) {
    double noise = setup.rangeNoise();
    double farthest = setup.lidarRange() * (1 + MOST_DEVIATIONS * noise);
    double range = RayCast.distance(now.grid(), from, direction, farthest);
    if (range >= farthest) {
      return false;
    }
    double read = noise > 0 ? range * (1 + noise * random.nextGaussian()) : range;
    return read < setup.lidarRange();
  }

  private List<SwarmRobot> moved(SwarmMap now, List<SwarmRobot> robots, Vec2 leader, Vec2 forward) {
    List<SwarmRobot> left = new ArrayList<>(robots.size());
    double noise = setup.actuatorNoise();
    for (SwarmRobot robot : robots) {
      Vec2 d =
          setup.keeping().equals(ShapeKeeping.NONE)
              ? forward
              : setup.keeping().displacement(robot, leader, forward, nearest(now, robot));
      if (noise > 0) {
        d = d.plus(new Vec2(random.nextGaussian(), random.nextGaussian()).times(noise * speed));
      }
      Vec2 position = robot.position().plus(d);
      if (!now.touches(position, setup.robotRadius())) {
        left.add(new SwarmRobot(position, robot.wanted()));
      }
    }
    return left;
  }

  /** From a robot's rim to the nearest thing that one of its feelers finds. */
  private Vec2 nearest(SwarmMap now, SwarmRobot robot) {
    double reach = setup.robotRadius() + setup.keeping().clearance();
    if (!now.touches(robot.position(), reach)) {
      return Vec2.ZERO;
    }
    double nearest = reach;
    double towards = 0;
    for (int i = 0; i < FEELERS; i++) {
      double direction = 2 * Math.PI * i / FEELERS;
      double range = RayCast.distance(now.grid(), robot.position(), direction, nearest);
      if (range < nearest) {
        nearest = range;
        towards = direction;
      }
    }
    double gap = Math.max(1e-3, nearest - setup.robotRadius());
    return nearest < reach ? new Vec2(gap, 0).rotated(towards) : Vec2.ZERO;
  }
}
