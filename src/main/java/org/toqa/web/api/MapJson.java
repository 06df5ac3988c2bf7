package org.toqa.web.api;

import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.web.api.DrawingJson.AreaJson;

/**
 * A floor on the wire.
 *
 * @param width cells, to the east
 * @param height cells, to the south
 * @param resolution metres along a cell's side
 * @param origin metres, the lower left corner of the lower left cell in the map frame
 * @param occupied runs of cells that are not free, those of keep-out areas too, row by row from the
 *     top: index of the first cell (row times width plus column), number of cells, and so on by
 *     turns
 * @param margins kept from walls, metres
 * @param version names what is drawn: another map has another name
 */
record MapJson(
    String floor,
    int width,
    int height,
    double resolution,
    Vec2 origin,
    List<PlaceJson> stations,
    List<PlaceJson> parking,
    List<PlaceJson> charging,
    List<Integer> occupied,
    List<AreaJson> keepOut,
    List<AreaJson> speedLimits,
    List<AreaJson> oneWay,
    List<AreaJson> freeZones,
    Margins margins,
    String version) {

  /** Metres, map frame. */
  record PlaceJson(String name, double x, double y) {
    static PlaceJson of(Place place) {
      return new PlaceJson(place.name(), place.position().x(), place.position().y());
    }
  }

  static MapJson of(FloorMap floor) {
    OccupancyGrid grid = floor.grid();
    DrawingJson areas = DrawingJson.of(floor.drawing());
    return new MapJson(
        floor.name(),
        grid.width(),
        grid.height(),
        grid.resolution(),
        grid.origin(),
        floor.stations().stream().map(PlaceJson::of).toList(),
        floor.parking().stream().map(PlaceJson::of).toList(),
        floor.charging().stream().map(PlaceJson::of).toList(),
        CellRuns.of(grid.occupied()).runs(),
        areas.keepOut(),
        areas.speedLimits(),
        areas.oneWay(),
        areas.freeZones(),
        floor.margins(),
        floor.version());
  }
}
