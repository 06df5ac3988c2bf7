package org.toqa.fleet;

import java.util.List;
import java.util.Optional;
import org.toqa.grid.FloorDrawing;
import org.toqa.wording.Sentence;

/**
 * Keeps something by the names of floors, which come back: a new floor may have the name of one
 * that was removed, and begins with nothing of it. Called on the thread that changes floors.
 */
public interface FloorListener {

  /** What a person must do before that floor can be removed; empty: nothing. */
  Optional<Sentence> objectionToRemoval(String floor);

  /** What follows for it when that drawing is the floor's map, or what speaks against that. */
  default List<MapProblem> mapProblems(String floor, FloorDrawing drawing) {
    return List.of();
  }

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
