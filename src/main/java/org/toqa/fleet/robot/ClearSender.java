package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Sends a robot that a person has cleared its stops, under the same number until it is answered, so
 * that what comes twice has no further effect. Over another connection it is never sent: the person
 * looked at the robot before. Confined to the robot's agent.
 */
final class ClearSender {
  private static final Duration REPEAT_AFTER = Duration.ofSeconds(1);

  /** So often it is sent at most. */
  private static final int MAX_SENDS = 4;

  private final String robot;
  private final Consumer<Clear> link;
  private @Nullable Clear pending;
  private Instant lastSent = Instant.EPOCH;
  private int sends;

  /**
   * @param link is given it each time
   */
  ClearSender(String robot, Consumer<Clear> link) {
    this.robot = robot;
    this.link = link;
  }

  /**
   * @param seq its number, which no other command has
   */
  void begin(long seq, Set<String> reasons, Instant now) {
    pending = new Clear(seq, reasons.stream().sorted().toList());
    sends = 0;
    send(pending, now);
  }

  private void send(Clear clear, Instant now) {
    sends++;
    lastSent = now;
    link.accept(clear);
  }

  /**
   * Sends it again if it is time.
   *
   * @return why it is given up, if it just is
   */
  Optional<Sentence> repeat(Instant now) {
    Clear clear = pending;
    if (clear == null || now.isBefore(lastSent.plus(REPEAT_AFTER))) {
      return Optional.empty();
    }
    if (sends == MAX_SENDS) {
      pending = null;
      return Optional.of(Phrase.CLEAR_NOT_ANSWERED.with(robot));
    }
    send(clear, now);
    return Optional.empty();
  }

  /**
   * A command of that number was answered.
   *
   * @return whether it was this one
   */
  boolean settle(long seq) {
    boolean isAnswered = pending != null && pending.seq() == seq;
    if (isAnswered) {
      pending = null;
    }
    return isAnswered;
  }

  /**
   * The robot has connected anew: what it has not heard until now it never will.
   *
   * @param lastSeq the highest number that it has accepted
   * @return why the clear is given up, if it just is
   */
  Optional<Sentence> reconnected(long lastSeq) {
    Clear clear = pending;
    pending = null;
    return clear == null || lastSeq >= clear.seq()
        ? Optional.empty()
        : Optional.of(Phrase.CLEAR_NOT_ANSWERED.with(robot));
  }
}
