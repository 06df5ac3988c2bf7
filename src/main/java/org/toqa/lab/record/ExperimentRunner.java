package org.toqa.lab.record;

import java.util.function.BooleanSupplier;
import org.toqa.lab.experiment.Run.ProgressListener;

/** Does experiments where they disturb nobody. */
public interface ExperimentRunner {
  /** How a run ended. */
  sealed interface Outcome {
    record Done(LabResult result) implements Outcome {}

    /** As it was asked to. */
    record Stopped() implements Outcome {}

    /**
     * @param detail why, for a person, in English
     */
    record Failed(String detail) implements Outcome {}
  }

  /**
   * Does one, and returns when nothing of it goes on.
   *
   * @param listener is told how far it is, by any thread
   * @param isStopped whether it is to end early
   * @throws InterruptedException the thread was interrupted, and the run ended
   */
  Outcome run(LabOrder order, ProgressListener listener, BooleanSupplier isStopped)
      throws InterruptedException;
}
