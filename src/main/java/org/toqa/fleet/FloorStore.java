package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.persistence.StoreException;

/**
 * The floors that there are, with their maps and drafts.
 *
 * <p>Each call is one transaction, as those of {@link FleetStore}. Calls may wait.
 */
public interface FloorStore {

  /** All floors with the maps in force, the first one the default. */
  List<FloorMap> floors();

  /**
   * Adds a floor as the last one.
   *
   * @return false: there is one of that name, without regard to case; nothing has changed then
   */
  boolean addFloor(FloorMap map, Change change);

  /**
   * Removes a floor with its draft and all that is kept by its name, but for the history: events,
   * maps that were in force, ended tasks, and what the replay shows.
   */
  void removeFloor(String floor, Change change);

  /** The floor's draft, or what is in force where there is none; empty: no such floor. */
  Optional<FloorDraft> draft(String floor);

  /**
   * Stores what a floor is to look like.
   *
   * @param seen the revision that it was made of
   * @return empty: there is another revision by now, and nothing has changed
   */
  Optional<FloorDraft> saveDraft(
      String floor, FloorDrawing drawing, long seen, String user, Instant at);

  /**
   * Nothing happens where there is none.
   *
   * @param seen its revision; null: whichever it is
   * @return false: there is another revision by now, and nothing has changed
   */
  boolean discardDraft(String floor, @Nullable Long seen);

  /**
   * Puts a draft in force, and forgets it.
   *
   * @param seen its revision
   * @return the map in force; empty: there is another revision by now, and nothing has changed
   * @throws StoreException the store does not answer: it has happened as a whole, or not at all
   */
  Optional<FloorMap> publish(String floor, long seen, Change change);

  /** The map that was in force then; empty: there was none. */
  Optional<FloorMap> mapAt(String floor, Instant at);

  /**
   * Who changes floors, and what the history says of it.
   *
   * @param user null: the server itself
   */
  record Change(@Nullable String user, Instant at, List<EventRecord> events) {
    public Change {
      events = List.copyOf(events);
    }
  }
}
