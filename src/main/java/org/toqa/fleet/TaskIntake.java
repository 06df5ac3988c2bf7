package org.toqa.fleet;

import java.time.Duration;
import java.util.UUID;
import java.util.function.Consumer;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.mission.TransportTask;

/**
 * Stores new tasks so that their askers hear the truth: a task that was accepted is stored, and one
 * that was not is not stored later, when nobody waits for it any more.
 */
final class TaskIntake {
  /** Shorter than any asker waits for the answer. */
  private static final Duration LIMIT = Duration.ofSeconds(8);

  private final FleetStore store;
  private final StoreWriter writer;

  TaskIntake(FleetStore store, StoreWriter writer) {
    this.store = store;
    this.writer = writer;
  }

  /**
   * Stores the task, in time or not at all.
   *
   * @param accepted gets the task with its id, on the writer's thread
   * @param refused called there when it was not stored
   */
  void take(TransportTask task, Consumer<TransportTask> accepted, Runnable refused) {
    UUID submission = UUID.randomUUID();
    long deadline = System.nanoTime() + LIMIT.toNanos();
    writer.tryOnce(
        () -> {
          inTime(deadline);
          TransportTask stored = store.addTask(task, submission);
          inTime(deadline);
          accepted.accept(stored);
        },
        () -> {},
        failure -> {
          refused.run();
          writer.write(() -> store.withdraw(submission), () -> {});
        });
  }

  private static void inTime(long deadline) {
    if (System.nanoTime() - deadline > 0) {
      throw new StoreException("It took the database more than " + LIMIT.toSeconds() + " s.", null);
    }
  }
}
