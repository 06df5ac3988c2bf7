package org.toqa.fleet.floor;

/**
 * Whether a robot has taken the room beside its path that it was lent: then it says when it is
 * over.
 */
final class RoomState {
  private boolean isTaken;

  /** It was lent room, and has not said yet that it takes it. */
  void lend() {
    isTaken = false;
  }

  void take() {
    isTaken = true;
  }

  boolean isTaken() {
    return isTaken;
  }
}
