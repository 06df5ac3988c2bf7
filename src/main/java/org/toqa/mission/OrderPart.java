package org.toqa.mission;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Which part of an order a task is: one of its pieces, or a leg from one stop to the next.
 *
 * @param order its id; 0: the order is not stored yet
 * @param name of the order
 * @param position from 1; a part that ended without delivery may be ordered again: the newest task
 *     of a position counts
 * @param count how many parts were ordered
 * @param awaitsPrevious whether it begins only when the part before it is delivered
 */
public record OrderPart(
    long order, String name, Kind kind, int position, int count, boolean awaitsPrevious) {

  public enum Kind {
    /** Each is carried for itself, by whichever robots are free. */
    PIECES,
    /** One load from stop to stop: a leg begins where the one before it ended. */
    STOPS
  }

  /**
   * The task of the part before.
   *
   * @param task its id
   */
  public record Previous(long task, TaskState state) {}

  /** A part of an order that is not stored yet. */
  public static OrderPart ofNew(String name, Kind kind, int position, int count) {
    return new OrderPart(0, name, kind, position, count, kind == Kind.STOPS && position > 1);
  }

  /** The same of the order that has that id. */
  public OrderPart withOrder(long stored) {
    return new OrderPart(stored, name, kind, position, count, awaitsPrevious);
  }

  public OrderPart withAwaitsPrevious(boolean awaits) {
    return new OrderPart(order, name, kind, position, count, awaits);
  }

  /** Whether it can never begin by itself: what it waits for has ended without delivery. */
  public boolean isStoppedBy(@Nullable Previous previous) {
    return awaitsPrevious
        && (previous == null || (previous.state().isEnded() && !previous.state().isDelivered()));
  }

  /**
   * Why it may not begin yet; empty: it may.
   *
   * @param previous null: it was deleted
   */
  public Optional<Sentence> reasonToWait(@Nullable Previous previous) {
    if (!awaitsPrevious || (previous != null && previous.state().isDelivered())) {
      return Optional.empty();
    }
    if (previous == null) {
      return Optional.of(Phrase.LEG_BEFORE_IS_GONE.with(position - 1, count));
    }
    Phrase phrase = isStoppedBy(previous) ? Phrase.LEG_BEFORE_ENDED : Phrase.LEG_BEFORE_COMES_FIRST;
    return Optional.of(phrase.with(position - 1, count, previous.task()));
  }
}
