package org.toqa.notices;

import java.time.Instant;
import java.util.UUID;
import org.jspecify.annotations.Nullable;

/**
 * A notice, or its end, that is to be told to one receiver.
 *
 * @param uid the same each time it is tried
 * @param ending whether it tells the end
 * @param notBefore when it may be tried first
 */
public record Delivery(UUID uid, Receiver receiver, boolean ending, Instant notBefore) {

  /** Who is told. */
  public sealed interface Receiver {
    /** By letter. */
    record OfPerson(long account) implements Receiver {}

    record OfWebhook(long webhook) implements Receiver {}
  }

  /** What became of one. */
  public enum State {
    WAITING,
    SENT,
    /** It was tried for long in vain. */
    GIVEN_UP
  }

  /**
   * One that is due.
   *
   * @param id in the store
   * @param attempts how often it was tried in vain
   * @param createdAt when it was accepted
   */
  public record Due(long id, Delivery delivery, Notice notice, int attempts, Instant createdAt) {}

  /**
   * What became of one, for people.
   *
   * @param to the name of the person, or the webhook's address
   * @param nextAt when it is tried next, if it waits
   * @param failure what went wrong last, in English; null: nothing
   */
  public record Outcome(
      Receiver receiver,
      String to,
      boolean ending,
      State state,
      int attempts,
      Instant nextAt,
      @Nullable Instant doneAt,
      @Nullable String failure) {}
}
