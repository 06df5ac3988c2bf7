package org.toqa.app.server;

import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;

/** Places to put simulated robots where the parking points do not suffice. */
public final class FreeCells {
  private FreeCells() {}

  /** Every second free cell of every second row that is no named place, row by row from the top. */
  public static Stream<Place> of(FloorMap floor) {
    OccupancyGrid grid = floor.grid();
    Set<Cell> named =
        Stream.of(floor.stations(), floor.parking(), floor.charging())
            .flatMap(places -> places.stream())
            .map(place -> grid.cellAt(place.position()))
            .collect(Collectors.toSet());
    return IntStream.range(0, grid.width() * grid.height())
        .mapToObj(grid::cell)
        .filter(c -> c.column() % 2 == 1 && c.row() % 2 == 1 && grid.isFree(c))
        .filter(c -> !named.contains(c))
        .map(c -> new Place("cell " + c, grid.centre(c)));
  }
}
