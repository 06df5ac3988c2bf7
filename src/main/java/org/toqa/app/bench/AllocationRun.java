package org.toqa.app.bench;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.allocation.Energy;
import org.toqa.allocation.Job;
import org.toqa.allocation.Situation;
import org.toqa.allocation.Situation.Given;
import org.toqa.allocation.Standing;
import org.toqa.app.bench.Shift.Worker;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/**
 * A shift's work under one allocator, from event to event: a task comes, or a robot has driven a
 * leg. Robots do not hinder each other.
 */
final class AllocationRun {
  /** As many as the fleet lets take part in a round. */
  private static final int LOOKED_AT = 200;

  private final Shift shift;
  private final Allocator allocator;
  private final boolean mayExchange;
  private final Map<String, Robot> robots = new LinkedHashMap<>();
  private final Deque<Job> coming;
  private final Map<Long, Job> waiting = new TreeMap<>();
  private final List<Double> secondsToGoal = new ArrayList<>();
  private final List<Double> roundMillis = new ArrayList<>();
  private Instant now = Shift.BEGIN;
  private double metres;
  private double joules;

  /**
   * @param meanSeconds from a task's coming to its delivery
   * @param worstSeconds the same, of the task that took longest
   * @param joules of all robots' driving
   * @param metres driven by all robots
   * @param roundP99Ms processor time of a round, milliseconds
   */
  record Report(
      int delivered,
      double meanSeconds,
      double worstSeconds,
      double joules,
      double metres,
      double roundP99Ms) {}

  private enum Phase {
    PARKED,
    TO_LOAD,
    CARRYING,
    HOME
  }

  private static final class Robot {
    private final Worker worker;
    private Phase phase = Phase.PARKED;
    private @Nullable Job job;
    private @Nullable Leg leg;
    private Vec2 position;

    Robot(Worker worker) {
      this.worker = worker;
      position = worker.home();
    }
  }

  /**
   * @param mayExchange whether a task whose load is not picked up may go to another robot
   */
  AllocationRun(Shift shift, Allocator allocator, boolean mayExchange) {
    this.shift = shift;
    this.allocator = allocator;
    this.mayExchange = mayExchange;
    this.coming = new ArrayDeque<>(shift.jobs());
    shift.robots().forEach(worker -> robots.put(worker.name(), new Robot(worker)));
  }

  Report run() {
    Optional<Instant> next = nextEvent();
    while (next.isPresent()) {
      now = next.get();
      boolean due = arrivals();
      due |= legsEnded();
      if (due) {
        round();
      }
      next = nextEvent();
    }
    Timings seconds = timings(secondsToGoal);
    return new Report(
        secondsToGoal.size(),
        seconds.mean(),
        seconds.max(),
        joules,
        metres,
        timings(roundMillis).percentile(0.99));
  }

  private static Timings timings(List<Double> values) {
    return new Timings(values.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private Optional<Instant> nextEvent() {
    Stream<Instant> ends =
        robots.values().stream().flatMap(r -> Stream.ofNullable(r.leg)).map(Leg::end);
    Stream<Instant> arrival = Stream.ofNullable(coming.peek()).map(Job::countsFrom);
    return Stream.concat(ends, arrival).min(Comparator.naturalOrder());
  }

  private boolean arrivals() {
    boolean any = false;
    while (!coming.isEmpty() && !coming.peek().countsFrom().isAfter(now)) {
      Job job = coming.remove();
      waiting.put(job.id(), job);
      any = true;
    }
    return any;
  }

  /** Whether a robot has become free. */
  private boolean legsEnded() {
    boolean free = false;
    for (Robot robot : robots.values()) {
      if (robot.leg != null && !robot.leg.end().isAfter(now)) {
        stop(robot);
        free |= robot.phase == Phase.CARRYING;
        goOn(robot);
      }
    }
    return free;
  }

  private void goOn(Robot robot) {
    switch (robot.phase) {
      case TO_LOAD -> drive(robot, Phase.CARRYING, requireNonNull(robot.job).goal());
      case CARRYING -> {
        Job delivered = requireNonNull(robot.job);
        secondsToGoal.add(Duration.between(delivered.countsFrom(), now).toMillis() / 1000.0);
        robot.job = null;
        drive(robot, Phase.HOME, robot.worker.home());
      }
      case HOME, PARKED -> robot.phase = Phase.PARKED;
    }
  }

  private void drive(Robot robot, Phase phase, Vec2 to) {
    robot.phase = phase;
    robot.leg = new Leg(shift.grid(), robot.position, to, now, robot.worker.speed());
  }

  /** It stands where it is now. */
  private void stop(Robot robot) {
    if (robot.leg != null) {
      double driven = robot.leg.driven(now);
      boolean loaded = robot.phase == Phase.CARRYING;
      metres += driven;
      joules += Energy.joules(driven, loaded ? requireNonNull(robot.job).load() : 0);
      robot.position = robot.leg.at(now);
      robot.leg = null;
    }
  }

  private void round() {
    Situation situation = situation();
    double begin = Timings.processorMillis();
    List<Decision> decisions = allocator.allocate(situation);
    roundMillis.add(Timings.processorMillis() - begin);
    Map<Robot, Job> begun = new LinkedHashMap<>();
    for (Decision decision : decisions) {
      if (decision instanceof Decision.Assigned(long id, List<String> names, var _)) {
        Job job = Optional.ofNullable(waiting.remove(id)).orElseGet(() -> takenBack(id));
        begun.put(requireNonNull(robots.get(names.getFirst())), job);
      }
    }
    begun.forEach(
        (robot, job) -> {
          stop(robot);
          robot.job = job;
          drive(robot, Phase.TO_LOAD, job.start());
        });
  }

  /** From the robot that is on its way to the load, which turns home. */
  private Job takenBack(long id) {
    Robot robot =
        robots.values().stream()
            .filter(r -> r.job != null && r.job.id() == id)
            .findFirst()
            .orElseThrow();
    Job job = requireNonNull(robot.job);
    stop(robot);
    robot.job = null;
    drive(robot, Phase.HOME, robot.worker.home());
    return job;
  }

  private Situation situation() {
    OccupancyGrid grid = shift.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    List<Given> given =
        robots.values().stream()
            .filter(r -> mayExchange && r.phase == Phase.TO_LOAD)
            .map(r -> new Given(requireNonNull(r.job), r.worker.name()))
            .toList();
    return new Situation(
        now,
        grid.origin(),
        grid.origin().plus(size),
        shift.distances(),
        List.of(),
        waiting.values().stream().limit(LOOKED_AT).toList(),
        given,
        robots.values().stream().map(this::candidate).toList(),
        List.of());
  }

  private Candidate candidate(Robot robot) {
    Job job = robot.job;
    return new Candidate(
        robot.worker.name(),
        robot.worker.maxLoad(),
        Shift.DIAMETER,
        robot.worker.speed(),
        robot.leg == null ? robot.position : robot.leg.at(now),
        robot.worker.home(),
        null,
        job == null ? Standing.FREE : Standing.BUSY,
        job == null ? null : job.id());
  }
}
