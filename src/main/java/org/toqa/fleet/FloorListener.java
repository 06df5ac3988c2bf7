package org.toqa.fleet;

import java.util.Optional;
import org.toqa.wording.Sentence;

/**
 * Keeps something by the names of floors, which come back: a new floor may have the name of one
 * that was removed, and begins with nothing of it. Called on the thread that changes floors.
 */
public interface FloorListener {

  /** What a person must do before that floor can be removed; empty: nothing. */
  Optional<Sentence> objectionToRemoval(String floor);

  /**
   * That floor is there no more. When this returns nothing of it is kept, and one may come anew.
   */
  void floorRemoved(String floor);

  /** Of what a person removes before the floor, as schedules are. */
  @FunctionalInterface
  interface Objector extends FloorListener {
    @Override
    default void floorRemoved(String floor) {}
  }
}
