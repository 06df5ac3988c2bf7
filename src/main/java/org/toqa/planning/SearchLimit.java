package org.toqa.planning;

import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * A limit for all the searches that one thread makes in one call, however deep below it: one that
 * goes on for longer ends by an exception, and what it was for has no answer.
 */
public final class SearchLimit {
  private static final ScopedValue<BooleanSupplier> CURRENT = ScopedValue.newInstance();

  private SearchLimit() {}

  /** What is searched for was not found in time. */
  public static final class SearchTimeoutException extends RuntimeException {
    private static final long serialVersionUID = 1;

    SearchTimeoutException() {
      super("The search took too long.", null, false, false);
    }
  }

  /**
   * Does some work, whose searches end when they are told so.
   *
   * @param isOver asked again and again, by this thread
   * @throws SearchTimeoutException it was over before the work was done
   */
  public static <T> T within(BooleanSupplier isOver, Supplier<T> work) {
    return ScopedValue.where(CURRENT, isOver).call(work::get);
  }

  /**
   * Whether this thread is to search no longer; for searches that then answer with what they have.
   */
  public static boolean isOver() {
    return CURRENT.isBound() && CURRENT.get().getAsBoolean();
  }

  /**
   * To be called by every search whose length is not bounded otherwise, each millisecond or so.
   *
   * @throws SearchTimeoutException this thread is to search no longer
   */
  public static void check() {
    if (isOver()) {
      throw new SearchTimeoutException();
    }
  }
}
