package org.toqa.fleet.exploration;

import java.util.List;
import org.toqa.fleet.EventRecord;

/**
 * Keeps the last exploration of each floor. Each call is one transaction; it throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer. Called by threads that may
 * wait.
 */
public interface ExplorationStore {

  List<Exploration> explorations();

  /**
   * In the place of the one before on its floor.
   *
   * @param events what the history says of it; those that are there are not added again
   */
  void save(Exploration exploration, List<EventRecord> events);

  /** Forgets that of a floor, if there is one; the history keeps its lines. */
  void remove(String floor);
}
