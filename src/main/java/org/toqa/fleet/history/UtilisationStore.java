package org.toqa.fleet.history;

import java.util.List;

/**
 * What robots did. Called by threads that may wait; it throws what a {@link
 * org.toqa.fleet.FleetStore} throws.
 */
public interface UtilisationStore {

  /** A record of the same robot and moment is replaced. */
  void save(List<UtilisationRecord> records);
}
