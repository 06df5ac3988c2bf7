package org.toqa.fleet.history;

import java.util.Map;
import org.toqa.fleet.history.SeenPlaces.Sighting;
import org.toqa.fleet.history.SeenPlaces.Spot;

/**
 * What {@link SeenPlaces} knows, over restarts. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface SightingStore {
  Map<Spot, Sighting> sightings();

  /** Instead of all that was stored before. */
  void replace(Map<Spot, Sighting> sightings);
}
