package org.toqa.agent.config;

/** How a robot alone gets round what it sees. */
public enum Avoidance {
  /** On its path and in room that it is lent beside that. */
  WEIGHTED_DIRECTIONS("weighted-directions"),
  /** The same, and by four agents through free zones: on two wheels, with eight range sensors. */
  FOUR_AGENTS("four-agents");

  private final String word;

  Avoidance(String word) {
    this.word = word;
  }

  /** In the configuration. */
  public String word() {
    return word;
  }
}
