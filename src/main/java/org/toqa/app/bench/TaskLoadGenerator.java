package org.toqa.app.bench;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import org.toqa.app.command.StopSignal;
import org.toqa.app.server.FreeCells;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;

/** Random tasks all over a fleet's floors, on each always more than it has robots. */
final class TaskLoadGenerator {
  private static final double TASKS_PER_ROBOT = 1.5;
  private static final double LOAD_KG = 2;

  /** Orders that wait for their answers at once. */
  private static final int MOST_AT_ONCE = 50;

  private static final Duration POLL_PERIOD = Duration.ofMillis(250);

  private final Fleet fleet;

  /** By floor. */
  private final Map<String, List<Place>> places;

  private final int openTasks;
  private final Random random;

  /**
   * @param openTasks on each floor
   */
  private TaskLoadGenerator(
      Fleet fleet, Map<String, List<Place>> places, int openTasks, Random random) {
    this.fleet = fleet;
    this.places = places;
    this.openTasks = openTasks;
    this.random = random;
  }

  /**
   * @param robots of each floor
   * @param seed of where the tasks begin and end
   */
  static TaskLoadGenerator on(Fleet fleet, int robots, long seed) {
    Map<String, List<Place>> places = new LinkedHashMap<>();
    fleet.floors().forEach(floor -> places.put(floor.name(), FreeCells.of(floor).toList()));
    return new TaskLoadGenerator(
        fleet, places, (int) Math.ceil(TASKS_PER_ROBOT * robots), new Random(seed));
  }

  /**
   * Keeps the robots busy for so long, or until it is asked to end.
   *
   * @param seconds of real time
   * @param watcher gets each new snapshot
   * @throws Exception the fleet did not answer an order within 30 s, or failed at it
   */
  void run(int seconds, StopSignal stop, Consumer<FleetSnapshot> watcher) throws Exception {
    long end = System.nanoTime() + Duration.ofSeconds(seconds).toNanos();
    runUntil(() -> System.nanoTime() >= end, stop, watcher);
  }

  /**
   * Keeps the robots busy until it is over, or until it is asked to end.
   *
   * @param watcher gets each new snapshot
   * @throws Exception the fleet did not answer an order within 30 s, or failed at it
   */
  void runUntil(BooleanSupplier isOver, StopSignal stop, Consumer<FleetSnapshot> watcher)
      throws Exception {
    long version = -1;
    while (!isOver.getAsBoolean() && !stop.isRequested()) {
      FleetSnapshot snapshot = fleet.snapshots().awaitNewer(version, POLL_PERIOD);
      if (snapshot.version() > version) {
        version = snapshot.version();
        watcher.accept(snapshot);
        for (String floor : places.keySet()) {
          submitMissing(floor, fleet.snapshots(floor).orElseThrow().latest());
        }
      }
    }
  }

  /** Orders what is missing. Where there is no path, the fleet rejects it; there will be others. */
  private void submitMissing(String floor, FleetSnapshot snapshot) throws Exception {
    long missing = openTasks - openTasks(snapshot);
    while (missing > 0) {
      long together = Math.min(missing, MOST_AT_ONCE);
      List<CompletableFuture<Answer<TaskView>>> answers =
          LongStream.range(0, together).mapToObj(_ -> submitOne(floor)).toList();
      for (CompletableFuture<Answer<TaskView>> answer : answers) {
        answer.get(30, TimeUnit.SECONDS);
      }
      missing -= together;
    }
  }

  /** Of those that wait in the queue a snapshot has the first ones only, and how many there are. */
  static long openTasks(FleetSnapshot snapshot) {
    return snapshot.queuedCount()
        + snapshot.tasks().stream()
            .filter(task -> !task.state().isEnded() && task.state() != TaskState.QUEUED)
            .count();
  }

  private CompletableFuture<Answer<TaskView>> submitOne(String floor) {
    TaskOrder order =
        new TaskOrder(
            "Load", LOAD_KG, randomPlace(floor), randomPlace(floor), floor, 0, null, null);
    return fleet.submit(order, "bench").toCompletableFuture();
  }

  private Where randomPlace(String floor) {
    List<Place> there = requireNonNull(places.get(floor));
    return new Where.Point(there.get(random.nextInt(there.size())).position());
  }
}
