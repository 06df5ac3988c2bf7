package org.toqa.allocation;

/** Whether a robot can be given a task now, or what keeps it. */
public enum Standing {
  /** Idle, or on its way home. */
  FREE("is free", "are free"),
  BUSY("works on another task", "work on other tasks"),
  HELD("is held", "are held"),
  /** At a charging point, on its way there, or waiting for one. */
  CHARGING("must charge first", "must charge first"),
  OUT_OF_SERVICE("is out of service", "are out of service"),
  LOST("is lost: nothing is heard from it", "are lost"),
  CONNECTING("has not been heard of yet", "have not been heard of yet"),
  NOT_LOCALISED("does not know where it is", "do not know where they are"),
  ERROR("reports an error", "report an error");

  private final String ofOne;
  private final String ofSeveral;

  Standing(String ofOne, String ofSeveral) {
    this.ofOne = ofOne;
    this.ofSeveral = ofSeveral;
  }

  /** Follows a robot's name in a sentence. */
  String ofOne() {
    return ofOne;
  }

  /** Follows a number of robots in a sentence. */
  String ofSeveral() {
    return ofSeveral;
  }
}
