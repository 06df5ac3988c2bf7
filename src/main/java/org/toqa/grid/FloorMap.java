package org.toqa.grid;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A floor: its grid and what {@code name.floor.yaml} adds to it. Keep-out zones are already
 * occupied cells of the grid.
 *
 * @param margins that are kept on it
 */
public record FloorMap(
    String name,
    OccupancyGrid grid,
    List<Place> stations,
    List<Place> parking,
    List<Place> charging,
    Margins margins) {

  /** With the usual margins. */
  public FloorMap(
      String name,
      OccupancyGrid grid,
      List<Place> stations,
      List<Place> parking,
      List<Place> charging) {
    this(name, grid, stations, parking, charging, Margins.USUAL);
  }

  public FloorMap {
    stations = List.copyOf(stations);
    parking = List.copyOf(parking);
    charging = List.copyOf(charging);
  }

  public FloorMap withMargins(Margins kept) {
    return new FloorMap(name, grid, stations, parking, charging, kept);
  }

  /** The station, parking or charging point of that name. */
  public Optional<Place> place(String placeName) {
    return Stream.of(stations, parking, charging)
        .flatMap(List::stream)
        .filter(p -> p.name().equals(placeName))
        .findFirst();
  }
}
