package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;
import org.toqa.agent.chassis.SimulatedBodyFile;
import org.toqa.agent.chassis.SimulatedBodyFile.Reading;

/**
 * Where the bodies of a {@link CrashTestbed} really are, whoever simulates them, how near they came
 * to each other, how long they have stood there, and whether they were charged. It reads their
 * files about every millisecond.
 */
final class SiteTruth implements AutoCloseable {
  private static final double STILL = 0.002; // metres

  /** Of 20 ms or less: as long as a robot that was told to stop may still roll. */
  private static final long STEPS_OF_STANDSTILL = 300;

  /** Charging for a minute; no reading errs so much. */
  private static final double CHARGED = 0.02;

  /** Of each body, metres. */
  private static final double DIAMETER = 0.255;

  /** In a run of seconds there are thousands. */
  private static final long LEAST_MOMENTS = 100;

  private static final Duration TIMEOUT = Duration.ofMinutes(3);

  private final Map<String, SimulatedBodyFile> files = new LinkedHashMap<>();
  private final Map<String, Standing> standings = new ConcurrentHashMap<>();
  private final Map<String, Double> lowest = new ConcurrentHashMap<>();
  private final Thread reader;
  private final AtomicInteger charges = new AtomicInteger();
  private final AtomicLong moments = new AtomicLong();

  /** That were seen before the run began. */
  private long momentsBefore;

  private final AtomicReference<Approach> nearest = new AtomicReference<>(Approach.NONE);
  private volatile boolean closed;

  /**
   * How near two bodies came.
   *
   * @param metres between their middles
   */
  private record Approach(double metres, String one, String other) {
    static final Approach NONE = new Approach(Double.POSITIVE_INFINITY, "none", "none");

    Approach nearer(Approach other) {
      return other.metres() < metres ? other : this;
    }
  }

  /** That a robot has not moved since then. */
  private record Standing(Reading since, Reading last) {
    Standing next(Reading now) {
      boolean isStill =
          since.truePose().distanceTo(now.truePose()) < STILL && now.steps() >= last.steps();
      return isStill ? new Standing(since, now) : new Standing(now, now);
    }

    long steps() {
      return last.steps() - since.steps();
    }
  }

  /**
   * @param folders of the daemons, by the robots' names
   */
  SiteTruth(Map<String, Path> folders) throws IOException {
    for (Map.Entry<String, Path> folder : folders.entrySet()) {
      files.put(folder.getKey(), new SimulatedBodyFile(folder.getValue()));
    }
    reader = Thread.ofPlatform().daemon().name("truth").start(this::watch);
  }

  private void watch() {
    while (!closed) {
      long before = count();
      Map<String, Reading> moment = readings();
      moment.forEach(this::add);
      if (count() == before) { // else somebody may have moved between two of the readings
        judge(moment);
      }
      LockSupport.parkNanos(1_000_000);
    }
  }

  /** Of all that was written. */
  private long count() {
    long sum = 0;
    for (SimulatedBodyFile file : files.values()) {
      sum += file.count();
    }
    return sum;
  }

  private Map<String, Reading> readings() {
    Map<String, Reading> readings = new TreeMap<>();
    files.forEach((robot, file) -> file.read().ifPresent(now -> readings.put(robot, now)));
    return readings;
  }

  /** By centres and radii alone: all robots of a site are discs of the same size. */
  private void judge(Map<String, Reading> moment) {
    moments.incrementAndGet();
    moment.forEach(
        (one, here) ->
            moment.forEach(
                (other, there) -> {
                  if (one.compareTo(other) < 0) {
                    double metres = here.truePose().distanceTo(there.truePose());
                    nearest.accumulateAndGet(new Approach(metres, one, other), Approach::nearer);
                  }
                }));
  }

  /** Ends a run: no two bodies touched in it, so far as was seen. The next is judged by itself. */
  void endRun() {
    long seen = moments.get() - momentsBefore;
    momentsBefore += seen;
    Approach approach = nearest.getAndSet(Approach.NONE);
    assertTrue(seen > LEAST_MOMENTS, () -> "only " + seen + " moments were seen");
    assertTrue(approach.metres() >= DIAMETER, () -> "they touched: " + approach);
  }

  /** At how many moments all bodies were seen at once. */
  long moments() {
    return moments.get();
  }

  private void add(String robot, Reading now) {
    standings.merge(robot, new Standing(now, now), (before, first) -> before.next(now));
    double low = lowest.merge(robot, now.battery(), Math::min);
    if (now.battery() > low + CHARGED) {
      lowest.put(robot, now.battery());
      charges.incrementAndGet();
    }
  }

  /** How often a battery was filled up by two percent. */
  int charges() {
    return charges.get();
  }

  /** Where the robots are when all of them have stood for a few seconds of their own time. */
  Map<String, Reading> awaitStandstill(List<String> robots) throws InterruptedException {
    robots.forEach(standings::remove); // what was before does not count
    long end = System.nanoTime() + TIMEOUT.toNanos();
    while (!haveStood(robots, STEPS_OF_STANDSTILL)) {
      assertTrue(System.nanoTime() < end, () -> robots + " do not stop: " + standings);
      TimeUnit.MILLISECONDS.sleep(5);
    }
    Map<String, Reading> places = new LinkedHashMap<>();
    robots.forEach(robot -> places.put(robot, standing(robot).last()));
    return places;
  }

  /** Whether each of them has stood for so many steps of its own. */
  boolean haveStood(List<String> robots, long steps) {
    return robots.stream().allMatch(robot -> stepsStood(robot) >= steps);
  }

  private long stepsStood(String robot) {
    Standing standing = standings.get(robot);
    return standing == null ? 0 : standing.steps();
  }

  private Standing standing(String robot) {
    return Objects.requireNonNull(standings.get(robot), robot);
  }

  /** Metres that it is now from where it was then. */
  double metresFrom(String robot, Reading then) {
    return standing(robot).last().truePose().distanceTo(then.truePose());
  }

  @Override
  public void close() {
    closed = true;
    try {
      reader.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    files.values().forEach(SimulatedBodyFile::close);
  }
}
