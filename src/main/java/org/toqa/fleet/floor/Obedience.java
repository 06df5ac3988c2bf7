package org.toqa.fleet.floor;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Whether a robot does what it is told. One that does not is left out for a while, and then tried
 * once more.
 */
final class Obedience {
  /** A robot that drives, or was moved meanwhile, refuses once or twice. */
  private static final int MAX_REFUSALS = 5;

  private static final int LONGEST_REASON = 200;

  /** In a row. */
  private int refusals;

  private @Nullable Sentence fault;
  private Instant leftOutUntil = Instant.MIN;

  /** Why it is left out, a clause about the robot; null: it is not. */
  @Nullable Sentence fault() {
    return fault;
  }

  /** Whether it has refused the last drive that it was told. */
  boolean hasRefused() {
    return refusals > 0;
  }

  /**
   * It has refused to drive.
   *
   * @param reason a sentence, as it says it
   */
  void recordRefusal(String reason, Instant now) {
    refusals++;
    if (refusals >= MAX_REFUSALS) {
      String told = reason.length() > LONGEST_REASON ? reason.substring(0, LONGEST_REASON) : reason;
      leaveOut(Phrase.REFUSES_TO_DRIVE.with(told.replaceFirst("\\.$", "")), now);
    }
  }

  /** It owes an answer for too long, also over a new connection. */
  void recordNoAnswer(Instant now) {
    leaveOut(Phrase.ANSWERS_NO_COMMANDS.with(), now);
  }

  private void leaveOut(Sentence why, Instant now) {
    fault = why;
    leftOutUntil = now.plus(RobotEvent.LEFT_OUT_FOR);
  }

  /** It has taken a drive, or a person has seen to it. */
  void reset() {
    refusals = 0;
    fault = null;
  }

  /** To be called at each tick. */
  void update(Instant now) {
    if (!leftOutUntil.isAfter(now)) {
      fault = null;
    }
  }
}
