package org.toqa.motion;

/** How a robot can move. */
public enum DriveKind {
  /** In every direction, whichever way it faces. */
  OMNI("omni"),
  /** Ahead and back, and by turning: never sideways. */
  DIFFERENTIAL("differential");

  private final String word;

  DriveKind(String word) {
    this.word = word;
  }

  /** For files and messages. */
  public String word() {
    return word;
  }

  /** What goes by that word; of one that is not known only the least is taken for granted. */
  public static DriveKind of(String word) {
    return word.equals(OMNI.word) ? OMNI : DIFFERENTIAL;
  }

  public boolean canGoSideways() {
    return this == OMNI;
  }
}
