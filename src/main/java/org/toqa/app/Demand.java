package org.toqa.app;

import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.grid.Place;

/** Random tasks all over a fleet's first floor, always more than it has robots. */
final class Demand {
  private static final double TASKS_A_ROBOT = 1.5;
  private static final double LOAD = 2; // kilograms

  private static final Duration LOOK_EVERY = Duration.ofMillis(250);

  private final Fleet fleet;
  private final List<Place> places;
  private final int open;
  private final Random random;

  private Demand(Fleet fleet, List<Place> places, int open, Random random) {
    this.fleet = fleet;
    this.places = places;
    this.open = open;
    this.random = random;
  }

  static Demand on(Fleet fleet, int robots, long seed) {
    List<Place> places = FreeCells.of(fleet.floors().getFirst()).toList();
    return new Demand(fleet, places, (int) Math.ceil(TASKS_A_ROBOT * robots), new Random(seed));
  }

  /**
   * Keeps the robots busy for so long, or until the wish to end.
   *
   * @param watcher gets each new snapshot
   */
  void keep(int seconds, StopSignal stop, Consumer<FleetSnapshot> watcher) throws Exception {
    long end = System.nanoTime() + Duration.ofSeconds(seconds).toNanos();
    long version = -1;
    while (System.nanoTime() < end && !stop.isWished()) {
      FleetSnapshot snapshot = fleet.feed().awaitNewer(version, LOOK_EVERY);
      if (snapshot.version() > version) {
        version = snapshot.version();
        watcher.accept(snapshot);
        fill(snapshot);
      }
    }
  }

  /** Orders what is missing. Where there is no way, the fleet refuses; there will be others. */
  private void fill(FleetSnapshot snapshot) throws Exception {
    long missing = open - snapshot.tasks().stream().filter(t -> !t.state().isEnded()).count();
    for (long i = 0; i < missing; i++) {
      TaskOrder order = new TaskOrder("Load", LOAD, place(), place(), null, 0, null, null);
      fleet.submit(order, "bench").toCompletableFuture().get(30, TimeUnit.SECONDS);
    }
  }

  private Where place() {
    return new Where.Point(places.get(random.nextInt(places.size())).position());
  }
}
