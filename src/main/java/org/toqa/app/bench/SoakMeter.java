package org.toqa.app.bench;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.toqa.app.bench.meter.HeapMemory;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.statistics.Percentiles;
import org.toqa.store.DatabaseSize;

/** Measures what a fleet leaves behind in hours of work, and what does not get on. */
final class SoakMeter {
  /** A task or a robot that has somewhere to drive, and does not get on for so long, is stuck. */
  static final Duration STUCK_AFTER = Duration.ofMinutes(30);

  /** Metres; who moved less stands. */
  private static final double MOVED = 0.05;

  private static final int SAMPLES = 24;

  private final InstantSource fleetTime;
  private final Duration sampleInterval;
  private final Supplier<DatabaseSize> databaseSize;

  /** Bytes; empty: that cannot be asked so often. */
  private final Supplier<OptionalLong> fileSize;

  private final int chargers;
  private final Instant begin;
  private final Map<Long, Instant> orderedAt = new HashMap<>();
  private final Map<Long, Duration> waits = new HashMap<>();
  private final Map<Long, Progress> tasks = new HashMap<>();
  private final Map<String, Place> robots = new HashMap<>();
  private final List<Sample> samples = new ArrayList<>();
  private Instant lastObserved;

  /** Bytes, since the last sample. */
  private long largestFile;

  private double emptySeconds;
  private double chargerSeconds;
  private int tasksDone;

  private record Progress(TaskState state, Instant since, String waitingFor) {}

  private record Place(Vec2 position, Instant since, String doing, boolean mayStand) {
    /** The later one, since when it is there. */
    Place andThen(Place later) {
      return position.distanceTo(later.position()) <= MOVED
          ? new Place(position, since, later.doing(), later.mayStand())
          : later;
    }
  }

  /**
   * How it was after so many hours.
   *
   * @param databaseMb what the database takes, in units of 10^6 bytes
   * @param largestMb the most that it took since the sample before this one; 0: not known
   * @param contentMb what of that is needed: its size if it were compacted
   * @param heapMb heap in use after a garbage collection, in the same units
   */
  record Sample(
      double hours,
      int tasksDone,
      double databaseMb,
      double largestMb,
      double contentMb,
      double heapMb) {}

  /** What a task waits for, or what a robot does, that does not get on. */
  record Stuck(String who, double minutes, String what) {}

  /**
   * @param hours of the fleet's time
   * @param seconds of real time
   * @param waitP50Seconds of the fleet's time, from a task's order to its first robots
   * @param emptyShare the share of their time in which robots had less than 5 % in their batteries
   * @param chargerUse the share of their time in which charging points charged
   * @param samples in equal distances, and at the end
   */
  record Report(
      double hours,
      double seconds,
      int tasksDone,
      double waitP50Seconds,
      double waitP99Seconds,
      double longestWaitSeconds,
      double emptyShare,
      double chargerUse,
      List<Sample> samples,
      List<Stuck> stuck) {}

  /**
   * @param length of the measurement, in the fleet's time
   * @param databaseSize what the server's database takes
   * @param fileSize bytes of its file, asked with each snapshot; empty: it has none
   * @param chargers how many charging points the floor has
   */
  SoakMeter(
      InstantSource fleetTime,
      Duration length,
      Supplier<DatabaseSize> databaseSize,
      Supplier<OptionalLong> fileSize,
      int chargers) {
    this.fleetTime = fleetTime;
    this.sampleInterval = length.dividedBy(SAMPLES);
    this.databaseSize = databaseSize;
    this.fileSize = fileSize;
    this.chargers = chargers;
    this.begin = fleetTime.instant();
    this.lastObserved = begin;
  }

  /** Adds a snapshot, each one after those before it. */
  void observe(FleetSnapshot snapshot) {
    Instant now = fleetTime.instant();
    double passed = seconds(Duration.between(lastObserved, now));
    lastObserved = now;
    largestFile = Math.max(largestFile, fileSize.get().orElse(0));
    snapshot.tasks().forEach(task -> observe(task, now));
    tasks.keySet().retainAll(snapshot.tasks().stream().map(TaskView::id).toList());
    for (RobotView robot : snapshot.robots()) {
      observe(robot, now);
      Double battery = robot.telemetry().battery();
      emptySeconds += battery != null && battery < 0.05 ? passed : 0;
      chargerSeconds += robot.state() == RobotState.CHARGING ? passed : 0;
    }
    Duration since = Duration.between(begin, now);
    if (since.compareTo(sampleInterval.multipliedBy(samples.size() + 1L)) >= 0) {
      addSample(since);
    }
  }

  private void observe(TaskView task, Instant now) {
    orderedAt.putIfAbsent(task.id(), now);
    if (!task.robots().isEmpty()) {
      waits.computeIfAbsent(
          task.id(), id -> Duration.between(Objects.requireNonNull(orderedAt.get(id)), now));
    }
    Progress before = tasks.get(task.id());
    if (before == null || before.state() != task.state()) {
      tasks.put(task.id(), new Progress(task.state(), now, waitingFor(task)));
      tasksDone += task.state() == TaskState.DONE && before != null ? 1 : 0;
    } else {
      tasks.put(task.id(), new Progress(task.state(), before.since(), waitingFor(task)));
    }
  }

  private static String waitingFor(TaskView task) {
    return task.waitingFor() == null ? task.state().name() : task.waitingFor().english();
  }

  private void observe(RobotView robot, Instant now) {
    Pose pose = robot.telemetry().pose();
    if (pose == null) {
      return;
    }
    Place here =
        new Place(
            pose.position(), now, robot.work().doing().english(), robot.path().points().isEmpty());
    robots.merge(robot.name(), here, Place::andThen);
  }

  private void addSample(Duration since) {
    DatabaseSize size = databaseSize.get();
    samples.add(
        new Sample(
            seconds(since) / 3600,
            tasksDone,
            size.bytes() / 1e6,
            largestFile / 1e6,
            size.contentBytes() / 1e6,
            HeapMemory.usedMegabytes()));
    largestFile = 0;
  }

  /**
   * @param realSeconds that it took
   */
  Report report(double realSeconds) {
    Duration since = Duration.between(begin, lastObserved);
    if (samples.isEmpty() || samples.getLast().hours() < seconds(since) / 3600) {
      addSample(since);
    }
    Percentiles wait =
        new Percentiles(waits.values().stream().mapToDouble(SoakMeter::seconds).toArray());
    double robotSeconds = Math.max(1, robots.size() * seconds(since));
    return new Report(
        seconds(since) / 3600,
        realSeconds,
        tasksDone,
        wait.percentile(0.5),
        wait.percentile(0.99),
        wait.max(),
        emptySeconds / robotSeconds,
        chargers == 0 ? 0 : chargerSeconds / Math.max(1, chargers * seconds(since)),
        List.copyOf(samples),
        stuck());
  }

  private List<Stuck> stuck() {
    Stream<Stuck> stuckTasks =
        tasks.entrySet().stream()
            .filter(entry -> !entry.getValue().state().isEnded())
            .filter(entry -> entry.getValue().state() != TaskState.QUEUED)
            .map(
                entry ->
                    new Stuck(
                        "task " + entry.getKey(),
                        minutesSince(entry.getValue().since()),
                        entry.getValue().waitingFor()));
    Stream<Stuck> stuckRobots =
        robots.entrySet().stream()
            .filter(entry -> !entry.getValue().mayStand())
            .map(
                entry ->
                    new Stuck(
                        entry.getKey(),
                        minutesSince(entry.getValue().since()),
                        entry.getValue().doing()));
    return Stream.concat(stuckTasks, stuckRobots)
        .filter(stuck -> stuck.minutes() >= STUCK_AFTER.toMinutes())
        .toList();
  }

  private double minutesSince(Instant since) {
    return seconds(Duration.between(since, lastObserved)) / 60;
  }

  private static double seconds(Duration duration) {
    return duration.toNanos() / 1e9;
  }
}
