package org.toqa.cooperation;

import java.util.List;

/** What robots are ordered to do; the supervisor is one of them. */
public sealed interface CarryCommand {

  /**
   * A robot with cameras drives on to where it has not seen the store.
   *
   * @param isAnew what was seen counts no more: a box is not where it was
   */
  record Search(String robot, boolean isAnew) implements CarryCommand {}

  /** A robot stands until it is told otherwise. */
  record Wait(String robot) implements CarryCommand {}

  /**
   * A worker drives to a box.
   *
   * @param isSecond to its other side, to help the one that waits there
   */
  record GoToBox(String worker, int box, boolean isSecond) implements CarryCommand {}

  /**
   * Workers at a box, one or two, carry it to its target.
   *
   * @param workers the one at its first side first
   */
  record Carry(List<String> workers, int box) implements CarryCommand {
    public Carry {
      workers = List.copyOf(workers);
    }
  }

  /** A robot drives to a charging station and charges. */
  record Charge(String robot, int station) implements CarryCommand {}

  /** A worker leaves its station for its parking place. */
  record Park(String worker) implements CarryCommand {}

  /** A person is asked: there are not two workers for a box that needs two. */
  record AskForWorker(int box) implements CarryCommand {}
}
