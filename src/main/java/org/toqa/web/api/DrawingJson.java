package org.toqa.web.api;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.CellRuns;
import org.toqa.grid.Direction;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;

/**
 * What is drawn of a floor, on the wire; {@link DrawingReader} reads it. The grid's fields are
 * those of {@link MapJson}, but keep-out areas are apart from walls.
 */
record DrawingJson(
    int width,
    int height,
    double resolution,
    Vec2 origin,
    List<Integer> occupied,
    List<PlaceJson> stations,
    List<PlaceJson> parking,
    List<PlaceJson> charging,
    List<AreaJson> keepOut,
    List<AreaJson> speedLimits,
    List<AreaJson> oneWay,
    List<AreaJson> freeZones,
    String moves) {

  /** Metres, map frame; degrees counter-clockwise from east. */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  record PlaceJson(
      String name, double x, double y, @Nullable Double headingDegrees, @Nullable String approach) {
    static PlaceJson of(Place place) {
      Double heading = place.heading();
      Direction approach = place.approach();
      return new PlaceJson(
          place.name(),
          place.position().x(),
          place.position().y(),
          heading == null ? null : rounded(Math.toDegrees(heading)),
          approach == null ? null : approach.word());
    }

    /** A whole number of degrees comes back as it was sent. */
    private static double rounded(double degrees) {
      return Math.rint(degrees * 1e9) / 1e9;
    }
  }

  /** Lower left corner and size, metres, map frame; with a speed, a direction or neither. */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  record AreaJson(
      double x,
      double y,
      double width,
      double height,
      @Nullable Double speed,
      @Nullable String direction) {
    static AreaJson of(Area area, @Nullable Double speed, @Nullable Direction direction) {
      return new AreaJson(
          area.low().x(),
          area.low().y(),
          area.width(),
          area.height(),
          speed,
          direction == null ? null : direction.word());
    }
  }

  static DrawingJson of(FloorDrawing drawing) {
    OccupancyGrid walls = drawing.walls();
    return new DrawingJson(
        walls.width(),
        walls.height(),
        walls.resolution(),
        walls.origin(),
        CellRuns.of(walls.occupied()).runs(),
        drawing.stations().stream().map(PlaceJson::of).toList(),
        drawing.parking().stream().map(PlaceJson::of).toList(),
        drawing.charging().stream().map(PlaceJson::of).toList(),
        drawing.keepOut().stream().map(area -> AreaJson.of(area, null, null)).toList(),
        drawing.speedLimits().stream()
            .map(limit -> AreaJson.of(limit.area(), limit.speed(), null))
            .toList(),
        drawing.oneWay().stream()
            .map(way -> AreaJson.of(way.area(), null, way.direction()))
            .toList(),
        drawing.freeZones().stream().map(area -> AreaJson.of(area, null, null)).toList(),
        drawing.moves().word());
  }
}
