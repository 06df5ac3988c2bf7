package org.toqa.app.bench;

import static java.util.Objects.requireNonNull;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonUnwrapped;
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
import org.toqa.allocation.AllocationMethod;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.AllocationTask;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Availability;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Decision;
import org.toqa.allocation.Energy;
import org.toqa.allocation.Negotiation;
import org.toqa.allocation.NegotiationCounts;
import org.toqa.allocation.Terrain;
import org.toqa.app.bench.AllocationWorkload.RobotSpec;
import org.toqa.app.bench.meter.ProcessorTime;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.statistics.Percentiles;

/**
 * A workload under one allocator, from event to event: a task comes, or a robot has driven a leg.
 * Robots do not hinder each other.
 */
final class AllocationRun {
  /** As many as the fleet lets take part in a round. */
  private static final int MAX_JOBS_PER_ROUND = 200;

  private final AllocationWorkload workload;
  private final AllocationMethod method;
  private final BidderFaults faults;
  private final boolean exchangeAllowed;
  private final Map<String, Robot> robots = new LinkedHashMap<>();
  private final Deque<AllocationTask> upcoming;
  private final Map<Long, AllocationTask> waiting = new TreeMap<>();
  private final List<Double> secondsToGoal = new ArrayList<>();
  private final List<Double> roundMillis = new ArrayList<>();
  private final List<Double> negotiationMillis = new ArrayList<>();
  private NegotiationCounts counts = NegotiationCounts.NONE;

  /** A round that is not over: robots and tasks go on meanwhile. */
  private @Nullable Pending pending;

  /** Whether something has changed since the last round began. */
  private boolean isRoundDue;

  private Instant now = AllocationWorkload.BEGIN;
  private double metres;
  private double joules;

  /**
   * @param delivered how many tasks
   * @param meanSeconds from when a task arrives until it is delivered
   * @param worstSeconds the same, of the task that took longest
   * @param joules energy of all robots together
   * @param metres driven by all robots together
   * @param roundP99Ms processor time of an allocation round, 99th percentile, milliseconds
   * @param negotiations null where none were held
   */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  record Report(
      int delivered,
      double meanSeconds,
      double worstSeconds,
      double joules,
      double metres,
      double roundP99Ms,
      @Nullable Negotiations negotiations) {}

  /**
   * @param meanMs how long one took, simulated milliseconds
   */
  record Negotiations(@JsonUnwrapped NegotiationCounts counts, double meanMs, double worstMs) {}

  private record Pending(Instant end, List<Decision> decisions) {}

  private enum Phase {
    PARKED,
    TO_LOAD,
    CARRYING,
    HOME
  }

  private static final class Robot {
    private final RobotSpec spec;
    private Phase phase = Phase.PARKED;
    private @Nullable AllocationTask job;
    private @Nullable TimedPath path;
    private Vec2 position;

    Robot(RobotSpec spec) {
      this.spec = spec;
      position = spec.home();
    }
  }

  /**
   * @param exchangeAllowed whether a task whose load is not picked up may go to another robot
   * @param faults how robots' agents answer in negotiations
   */
  AllocationRun(
      AllocationWorkload workload,
      AllocationMethod method,
      boolean exchangeAllowed,
      BidderFaults faults) {
    this.workload = workload;
    this.method = method;
    this.faults = faults;
    this.exchangeAllowed = exchangeAllowed;
    this.upcoming = new ArrayDeque<>(workload.jobs());
    workload.robots().forEach(worker -> robots.put(worker.name(), new Robot(worker)));
  }

  Report run() {
    Optional<Instant> next = nextEvent();
    while (next.isPresent()) {
      now = next.get();
      isRoundDue |= acceptArrivals();
      isRoundDue |= endPaths();
      if (pending != null && !pending.end().isAfter(now)) {
        List<Decision> decisions = pending.decisions();
        pending = null;
        apply(decisions);
      }
      if (isRoundDue && pending == null) {
        isRoundDue = false;
        beginRound();
      }
      next = nextEvent();
    }
    Percentiles seconds = timings(secondsToGoal);
    return new Report(
        secondsToGoal.size(),
        seconds.mean(),
        seconds.max(),
        joules,
        metres,
        timings(roundMillis).percentile(0.99),
        negotiations());
  }

  private @Nullable Negotiations negotiations() {
    Percentiles millis = timings(negotiationMillis);
    return negotiationMillis.isEmpty()
        ? null
        : new Negotiations(counts, millis.mean(), millis.max());
  }

  private static Percentiles timings(List<Double> values) {
    return new Percentiles(values.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private Optional<Instant> nextEvent() {
    Stream<Instant> ends =
        robots.values().stream().flatMap(r -> Stream.ofNullable(r.path)).map(TimedPath::end);
    Stream<Instant> arrival = Stream.ofNullable(upcoming.peek()).map(AllocationTask::waitsFrom);
    Stream<Instant> roundEnd = Stream.ofNullable(pending).map(Pending::end);
    return Stream.of(ends, arrival, roundEnd).flatMap(time -> time).min(Comparator.naturalOrder());
  }

  private boolean acceptArrivals() {
    boolean any = false;
    while (!upcoming.isEmpty() && !upcoming.peek().waitsFrom().isAfter(now)) {
      AllocationTask job = upcoming.remove();
      waiting.put(job.id(), job);
      any = true;
    }
    return any;
  }

  /** Whether a robot has become free. */
  private boolean endPaths() {
    boolean free = false;
    for (Robot robot : robots.values()) {
      if (robot.path != null && !robot.path.end().isAfter(now)) {
        stop(robot);
        free |= robot.phase == Phase.CARRYING;
        startNextPhase(robot);
      }
    }
    return free;
  }

  private void startNextPhase(Robot robot) {
    switch (robot.phase) {
      case TO_LOAD -> drive(robot, Phase.CARRYING, requireNonNull(robot.job).goal());
      case CARRYING -> {
        AllocationTask delivered = requireNonNull(robot.job);
        secondsToGoal.add(Duration.between(delivered.waitsFrom(), now).toMillis() / 1000.0);
        robot.job = null;
        drive(robot, Phase.HOME, robot.spec.home());
      }
      case HOME, PARKED -> robot.phase = Phase.PARKED;
    }
  }

  private void drive(Robot robot, Phase phase, Vec2 to) {
    robot.phase = phase;
    robot.path = new TimedPath(workload.grid(), robot.position, to, now, robot.spec.speed());
  }

  /** Ends its drive at the point that it has reached. */
  private void stop(Robot robot) {
    if (robot.path != null) {
      double driven = robot.path.drivenMetres(now);
      boolean loaded = robot.phase == Phase.CARRYING;
      metres += driven;
      joules += Energy.joules(driven, loaded ? requireNonNull(robot.job).load() : 0);
      robot.position = robot.path.positionAt(now);
      robot.path = null;
    }
  }

  private void beginRound() {
    AllocationProblem problem = situation();
    double begin = ProcessorTime.millis();
    switch (method) {
      case AllocationMethod.Computed(Allocator allocator) -> {
        List<Decision> decisions = allocator.allocate(problem);
        roundMillis.add(ProcessorTime.millis() - begin);
        apply(decisions);
      }
      case AllocationMethod.Negotiated _ -> {
        NegotiatedRound round = new NegotiatedRound(roundMillis.size(), problem, faults);
        Negotiation over = round.hold();
        roundMillis.add(ProcessorTime.millis() - begin);
        negotiationMillis.add((double) Duration.between(now, round.end()).toMillis());
        counts = counts.plus(over.counts());
        pending = new Pending(round.end(), over.decisions());
      }
    }
  }

  /** What has become impossible meanwhile is for the next round. */
  private void apply(List<Decision> decisions) {
    boolean areMovesPossible = decisions.stream().allMatch(this::isMovePossible);
    Map<Robot, AllocationTask> begun = new LinkedHashMap<>();
    Stream.concat( // moves first: they set robots free
            decisions.stream().filter(d -> !waiting.containsKey(d.task()) && areMovesPossible),
            decisions.stream().filter(d -> waiting.containsKey(d.task())))
        .forEach(decision -> apply(decision, begun));
    begun.forEach(
        (robot, job) -> {
          stop(robot);
          robot.job = job;
          drive(robot, Phase.TO_LOAD, job.start());
        });
  }

  private boolean isMovePossible(Decision decision) {
    return waiting.containsKey(decision.task())
        || holder(decision.task()).filter(robot -> robot.phase == Phase.TO_LOAD).isPresent();
  }

  private void apply(Decision decision, Map<Robot, AllocationTask> begun) {
    if (decision instanceof Decision.Assigned(long id, List<String> names, var _)) {
      Robot robot = requireNonNull(robots.get(names.getFirst()));
      if (!waiting.containsKey(id)) {
        begun.put(robot, takeBack(id));
      } else if (robot.job == null) {
        begun.put(robot, requireNonNull(waiting.remove(id)));
      } else {
        isRoundDue = true;
      }
    }
  }

  private Optional<Robot> holder(long task) {
    return robots.values().stream().filter(r -> r.job != null && r.job.id() == task).findFirst();
  }

  /** From the robot that drives to the load; it drives home instead. */
  private AllocationTask takeBack(long id) {
    Robot robot = holder(id).orElseThrow();
    AllocationTask job = requireNonNull(robot.job);
    stop(robot);
    robot.job = null;
    drive(robot, Phase.HOME, robot.spec.home());
    return job;
  }

  private AllocationProblem situation() {
    OccupancyGrid grid = workload.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    List<GivenTask> given =
        robots.values().stream()
            .filter(r -> exchangeAllowed && r.phase == Phase.TO_LOAD)
            .map(r -> new GivenTask(requireNonNull(r.job), r.spec.name()))
            .toList();
    return new AllocationProblem(
        now,
        grid.origin(),
        grid.origin().plus(size),
        new Terrain(workload.distances(), List.of()),
        waiting.values().stream().limit(MAX_JOBS_PER_ROUND).toList(),
        given,
        robots.values().stream().map(this::candidate).toList(),
        List.of());
  }

  private Candidate candidate(Robot robot) {
    AllocationTask job = robot.job;
    return new Candidate(
        robot.spec.name(),
        robot.spec.maxLoad(),
        AllocationWorkload.DIAMETER,
        robot.spec.speed(),
        true,
        robot.path == null ? robot.position : robot.path.positionAt(now),
        robot.spec.home(),
        null,
        job == null ? Availability.FREE : Availability.BUSY,
        job == null ? null : job.id());
  }
}
