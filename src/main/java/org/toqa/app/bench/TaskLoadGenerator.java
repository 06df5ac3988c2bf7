package org.toqa.app.bench;

import java.time.Duration;
import java.util.List;
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

/** Random tasks all over a fleet's first floor, always more than it has robots. */
final class TaskLoadGenerator {
  private static final double TASKS_PER_ROBOT = 1.5;
  private static final double LOAD_KG = 2;

  /** Orders that wait for their answers at once. */
  private static final int MOST_AT_ONCE = 50;

  private static final Duration POLL_PERIOD = Duration.ofMillis(250);

  private final Fleet fleet;
  private final List<Place> places;
  private final int openTasks;
  private final Random random;

  private TaskLoadGenerator(Fleet fleet, List<Place> places, int openTasks, Random random) {
    this.fleet = fleet;
    this.places = places;
    this.openTasks = openTasks;
    this.random = random;
  }

  /**
   * @param robots of the fleet
   * @param seed of where the tasks begin and end
   */
  static TaskLoadGenerator on(Fleet fleet, int robots, long seed) {
    List<Place> places = FreeCells.of(fleet.floors().getFirst()).toList();
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
        submitMissing(snapshot);
      }
    }
  }

  /** Orders what is missing. Where there is no path, the fleet rejects it; there will be others. */
  private void submitMissing(FleetSnapshot snapshot) throws Exception {
    long missing = openTasks - openTasks(snapshot);
    while (missing > 0) {
      long together = Math.min(missing, MOST_AT_ONCE);
      List<CompletableFuture<Answer<TaskView>>> answers =
          LongStream.range(0, together).mapToObj(_ -> submitOne()).toList();
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

  private CompletableFuture<Answer<TaskView>> submitOne() {
    TaskOrder order =
        new TaskOrder("Load", LOAD_KG, randomPlace(), randomPlace(), null, 0, null, null);
    return fleet.submit(order, "bench").toCompletableFuture();
  }

  private Where randomPlace() {
    return new Where.Point(places.get(random.nextInt(places.size())).position());
  }
}
