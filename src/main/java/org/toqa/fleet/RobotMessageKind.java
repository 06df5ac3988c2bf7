package org.toqa.fleet;

import java.util.Locale;
import org.toqa.wording.Phrase;

/** What a robot says, as far as it is limited: what is over the limit is left out and counted. */
public enum RobotMessageKind {
  /** States; the newest is never left out. */
  STATE(Phrase.STATES_OF_ROBOT, 500),
  /** Lines that make no sense. */
  UNREADABLE(Phrase.LINES_OF_ROBOT, 20),
  /** Ends of phases; a robot tells them again until they are acknowledged. */
  DONE(Phrase.ENDS_OF_ROBOT, 20),
  /** Answers to commands that were not sent. */
  ANSWER(Phrase.ANSWERS_OF_ROBOT, 20),
  /** Connections that end soon; none is left out, but the next one is made later. */
  CONNECTION(Phrase.CONNECTIONS_OF_ROBOT, 0),
  /** Obstacles, farther away than its sensors see or very many. */
  OBSTACLE(Phrase.OBSTACLES_OF_ROBOT, 500),
  /** Lines of the history that the robot causes. */
  EVENT(Phrase.EVENTS_OF_ROBOT, 0),
  /** All that is kept: the connection was closed. */
  BACKLOG(Phrase.MESSAGES_OF_ROBOT, 0);

  private final Phrase phrase;
  private final int tolerance;

  RobotMessageKind(Phrase phrase, int tolerance) {
    this.phrase = phrase;
    this.tolerance = tolerance;
  }

  /** For people. */
  public Phrase phrase() {
    return phrase;
  }

  /** So many that are left out within ten seconds are no reason to tell people. */
  public int tolerance() {
    return tolerance;
  }

  /** For metrics. */
  public String label() {
    return name().toLowerCase(Locale.ROOT);
  }
}
