package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.allocation.Policy;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;

/** What working robots cost the store, by counting. */
@Timeout(60)
class StoreRateTest {
  private static final int ROBOTS = 4;
  private static final int TASKS = 8;

  /** Changes that were asked for; of the segments of paths, how many were written. */
  private final AtomicInteger changes = new AtomicInteger();

  private final AtomicInteger transactions = new AtomicInteger();
  private final AtomicInteger begunSegments = new AtomicInteger();
  private final AtomicInteger addedSegments = new AtomicInteger();
  private final AtomicInteger ends = new AtomicInteger();

  private final ThreadLocal<Boolean> isWithin = ThreadLocal.withInitial(() -> false);
  private final FleetStage stage =
      new FleetStage(
          HallFleetTest.FLOOR,
          ChargingRules.USUAL,
          Policy.OPTIMAL.method(),
          store -> TamperedStore.of(store, this::count));

  private Object count(String method, Object[] arguments, TamperedStore.Call real)
      throws Throwable {
    if (method.equals("inOneTransaction")) {
      transactions.incrementAndGet();
      isWithin.set(true);
      try {
        return real.go(); // which calls this again
      } finally {
        isWithin.set(false);
      }
    }
    if (method.startsWith("save") || method.startsWith("add")) {
      changes.incrementAndGet();
      transactions.addAndGet(isWithin.get() ? 0 : 1);
    }
    if (method.equals("saveDrive")) {
      FleetStore.StoredDrive drive = (FleetStore.StoredDrive) arguments[1];
      begunSegments.addAndGet(drive.trajectory().segments().size());
    }
    if (method.equals("saveDriveEnd")) {
      ends.incrementAndGet();
      addedSegments.addAndGet(((List<?>) arguments[3]).size());
    }
    return real.go();
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void changesShareTransactionsAndPathsAreNotWrittenAgain() throws Exception {
    for (int i = 0; i < ROBOTS; i++) {
      stage.add("r" + i, new Vec2(0.5 + i, i % 2 == 0 ? 0.5 : 3.5), null);
    }
    stage.restart();
    for (int i = 0; i < TASKS; i++) {
      HallFleetTest.accepted(stage.fleet.submit(HallFleetTest.order(1), "Clara"));
    }
    stage.await(
        view ->
            view.queuedCount() == 0
                && view.tasks().stream()
                    .allMatch(
                        task -> task.state().isEnded() || task.state() == TaskState.RETURNING));

    String counted =
        "%d changes in %d transactions; %d ends with %d segments, drives begun with %d"
            .formatted(
                changes.get(),
                transactions.get(),
                ends.get(),
                addedSegments.get(),
                begunSegments.get());
    System.out.println(counted);
    assertTrue(transactions.get() < 0.8 * changes.get(), counted);
    assertTrue(addedSegments.get() <= 10 * ends.get(), counted);
  }
}
