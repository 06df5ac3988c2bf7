package org.toqa.web;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.LoadView;
import org.toqa.mission.TaskPlace;

/** All loads as readers see them: what lies at a station is said to be there. */
public final class Loads {
  private final Services services;

  public Loads(Services services) {
    this.services = services;
  }

  /** The newest first. */
  public List<LoadView> all() {
    return LoadView.of(services.fleet().snapshots().latest()).stream()
        .map(load -> load.withPlace(atStation(load)))
        .toList();
  }

  private @Nullable TaskPlace atStation(LoadView load) {
    TaskPlace place = load.place();
    if (place == null || place.station() != null) {
      return place;
    }
    return services.fleet().floors().stream()
        .filter(floor -> floor.name().equals(load.floor()))
        .flatMap(floor -> floor.stations().stream())
        .filter(s -> s.position().distanceTo(place.position()) < LoadView.SAME_PLACE)
        .map(station -> new TaskPlace(place.position(), station.name()))
        .findFirst()
        .orElse(place);
  }
}
