package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;

/**
 * Where loads were, and which paths robots had ahead. Called by threads that may wait; it throws
 * what a {@link org.toqa.fleet.FleetStore} throws.
 */
public interface SceneStore {

  /** One that is there already, with the same beginning, gets this end. */
  void save(List<LoadPlace> loads, List<PlannedPath> paths);

  /** Those that have not ended. */
  List<LoadPlace> openLoads();

  /** Those that have not ended. */
  List<PlannedPath> openPaths();

  /**
   * What there was in a period, which ends earlier where that is too much.
   *
   * @param until the first moment after it
   * @param most how many are wanted of either at most; those at its beginning come in any case
   */
  FloorScenes scenesOf(String floor, Instant from, Instant until, int most);
}
