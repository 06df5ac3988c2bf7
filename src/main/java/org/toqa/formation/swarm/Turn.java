package org.toqa.formation.swarm;

/** Where a swarm turns in a step. */
public enum Turn {
  LEFT(1),
  STRAIGHT(0),
  RIGHT(-1);

  private final int sign;

  Turn(int sign) {
    this.sign = sign;
  }

  /** 1 counter-clockwise, -1 clockwise, 0 straight on. */
  public int sign() {
    return sign;
  }

  /** The other side; straight on has none, and stays. */
  public Turn opposite() {
    return switch (this) {
      case LEFT -> RIGHT;
      case RIGHT -> LEFT;
      case STRAIGHT -> STRAIGHT;
    };
  }
}
