package org.toqa.fleet;

import java.time.Instant;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * All robots, or those of a floor, are on hold. This is no safety function: a robot that hears
 * nothing drives what was released to it to its end.
 *
 * @param user who put them on hold
 */
public record Hold(String user, Instant since) {

  /** What is said of all robots, which it is about. */
  public Sentence ofAll() {
    return Phrase.ALL_PAUSED_BY.with(user);
  }

  /** What is said of the robots of a floor, which it is about. */
  public Sentence ofFloor(String floor) {
    return Phrase.FLOOR_HELD_BY.with(floor, user);
  }
}
