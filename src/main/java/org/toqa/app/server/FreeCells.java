package org.toqa.app.server;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.sim.SimulatedFleet;
import org.toqa.traffic.RoadGraph;

/** Places to put simulated robots where the parking points do not suffice. */
public final class FreeCells {
  private FreeCells() {}

  /**
   * Cells in which a simulated robot has room, in the largest part of the floor that it can drive
   * in; two robots' diameters and two cells apart at least, and clear of the named places; row by
   * row from the top.
   */
  public static Stream<Place> of(FloorMap floor) {
    double diameter = SimulatedFleet.FOOTPRINT;
    RoadGraph roads = new RoadGraph(Inflation.inflate(floor.grid(), diameter / 2));
    OccupancyGrid grid = floor.grid();
    int step = Math.max(2, (int) Math.ceil(2 * diameter / grid.resolution()));
    List<Vec2> named =
        Stream.of(floor.stations(), floor.parking(), floor.charging())
            .flatMap(places -> places.stream().map(Place::position))
            .toList();
    return IntStream.range(0, roads.vertexCount())
        .filter(roads::isInLargestPart)
        .mapToObj(roads::cell)
        .filter(c -> c.column() % step == 1 && c.row() % step == 1)
        .filter(c -> named.stream().noneMatch(p -> p.distanceTo(grid.centre(c)) < diameter))
        .map(c -> new Place("cell " + c, grid.centre(c)));
  }
}
