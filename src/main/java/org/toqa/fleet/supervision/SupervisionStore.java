package org.toqa.fleet.supervision;

import java.util.List;
import org.toqa.fleet.EventRecord;

/**
 * Keeps the last supervision of each floor. Each call is one transaction; it throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer. Called by a thread that may
 * wait.
 */
public interface SupervisionStore {

  List<Supervision> supervisions();

  /**
   * In the place of the one before on its floor.
   *
   * @param events what the history says of it
   */
  void save(Supervision supervision, List<EventRecord> events);

  /** Forgets that of a floor, if there is one; the history keeps its lines. */
  void remove(String floor);
}
