package org.toqa.mission;

import java.util.Arrays;
import java.util.Optional;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What robots may be chosen by, instead of by their names. */
public enum RobotAbility {
  ARM("with:arm", Phrase.ROBOTS_WITH_ARM),
  /** It goes in every direction, whichever way it faces. */
  SIDEWAYS("with:omni", Phrase.ROBOTS_THAT_GO_SIDEWAYS);

  private final String word;
  private final Phrase robots;

  RobotAbility(String word, Phrase robots) {
    this.word = word;
    this.robots = robots;
  }

  /** Stands where a name may stand, and is none: no name has a colon. */
  public String word() {
    return word;
  }

  /** What goes by that word; empty: it is a robot's name. */
  public static Optional<RobotAbility> of(String word) {
    return Arrays.stream(values()).filter(ability -> ability.word.equals(word)).findFirst();
  }

  /** All robots that have it. */
  public Sentence robots() {
    return robots.with();
  }

  /** A robot, or those that go by that word. */
  public static Sentence sentence(String word) {
    return of(word).map(RobotAbility::robots).orElseGet(() -> Sentence.verbatim(word));
  }
}
