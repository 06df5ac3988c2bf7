package org.toqa.planning.smooth;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * When a planner that could go on for ever ends: after so many iterations, which gives the same
 * answer each time, or when told to.
 */
public final class PlanningBudget {
  private final long iterations;
  private final BooleanSupplier isOver;

  private PlanningBudget(long iterations, BooleanSupplier isOver) {
    this.iterations = iterations;
    this.isOver = isOver;
  }

  /**
   * So many iterations, however long they take.
   *
   * @throws IllegalArgumentException if there is none
   */
  public static PlanningBudget iterations(long count) {
    if (count < 1) {
      throw new IllegalArgumentException("A planner needs at least one iteration, not " + count);
    }
    return new PlanningBudget(count, () -> false);
  }

  /**
   * So much time from now on.
   *
   * @param nanoClock nanoseconds since any moment
   */
  public static PlanningBudget time(Duration limit, LongSupplier nanoClock) {
    long begin = nanoClock.getAsLong();
    long nanos = limit.toNanos();
    return new PlanningBudget(Long.MAX_VALUE, () -> nanoClock.getAsLong() - begin >= nanos);
  }

  /** Whether time is over, whatever the iterations. */
  boolean isTimeOver() {
    return isOver.getAsBoolean();
  }

  /** Whether no further iteration is to be made after so many. */
  boolean isSpent(long done) {
    return done >= iterations || isOver.getAsBoolean();
  }
}
