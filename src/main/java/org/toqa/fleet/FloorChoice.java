package org.toqa.fleet;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.grid.FloorMap;

/** Which floor is meant by whoever orders or asks something. */
public final class FloorChoice {

  /**
   * The floor of that name; where none is named, the first that has the stations that are named, or
   * the first of all.
   *
   * @return empty: there is no floor of that name
   */
  public static Optional<FloorMap> among(
      List<FloorMap> floors, @Nullable String name, Where start, Where goal) {
    return name != null
        ? floors.stream().filter(floor -> floor.name().equals(name)).findFirst()
        : floors.stream()
            .filter(floor -> has(floor, start) && has(floor, goal))
            .findFirst()
            .or(() -> floors.stream().findFirst());
  }

  private static boolean has(FloorMap floor, Where where) {
    return !(where instanceof Where.Station(String station))
        || floor.stations().stream().anyMatch(s -> s.name().equals(station));
  }

  private FloorChoice() {}
}
