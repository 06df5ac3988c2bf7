package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;

/**
 * Which loads and planned paths there were on a floor in a period.
 *
 * @param until the first moment after it; earlier than asked for where there was more than wanted
 * @param loads those of any moment of it, in the order of their beginnings
 * @param paths likewise
 */
public record FloorScenes(Instant until, List<LoadPlace> loads, List<PlannedPath> paths) {
  public FloorScenes {
    loads = List.copyOf(loads);
    paths = List.copyOf(paths);
  }
}
