package org.toqa.fleet;

import java.util.List;

/** What robots did. Called by threads that may wait; it throws what a {@link FleetStore} throws. */
public interface UseStore {

  /** A record of the same robot and moment is replaced. */
  void save(List<UseRecord> records);
}
