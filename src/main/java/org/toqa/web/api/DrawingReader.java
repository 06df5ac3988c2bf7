package org.toqa.web.api;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Direction;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorLimits;
import org.toqa.grid.MapLimits;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.grid.Place;
import org.toqa.grid.SpeedLimit;
import org.toqa.web.input.JsonFields;

/**
 * Reads what {@link DrawingJson} writes. Places may lie in walls, or off the grid: a drawing is
 * finished only when it is published.
 */
final class DrawingReader {
  /** Of walls; more would not fit into a body. */
  static final int MAX_RUNS = 500_000;

  /** Of a body with a drawing. */
  static final int MAX_BYTES = 16 * 1024 * 1024;

  private final JsonFields fields;
  private final Set<String> names = new HashSet<>();

  private DrawingReader(JsonFields fields) {
    this.fields = fields;
  }

  /** Files a sentence for each field that is wrong; what it then answers means nothing. */
  static FloorDrawing read(JsonFields fields) {
    DrawingReader reader = new DrawingReader(fields);
    FloorDrawing drawing =
        new FloorDrawing(
            reader.walls(),
            reader.places("stations"),
            reader.places("parking"),
            reader.places("charging"),
            reader.areas("keepOut", (item, area) -> area),
            reader.areas("speedLimits", (item, area) -> new SpeedLimit(area, speed(item))),
            reader.areas("oneWay", (item, area) -> new OneWay(area, direction(item, "direction"))),
            reader.areas("freeZones", (item, area) -> area),
            moves(fields));
    fields.refuseUnknown();
    return drawing;
  }

  private OccupancyGrid walls() {
    int width = size(fields.number("width"));
    int height = size(fields.number("height"));
    if (width < 1 || height < 1 || (long) width * height > MapLimits.MAX_CELLS) {
      refuse(fields, "width", "error.drawing.size", MapLimits.MAX_CELLS);
    }
    double resolution = resolution(fields);
    JsonFields corner = fields.object("origin");
    Vec2 origin = new Vec2(metres(corner, "x"), metres(corner, "y"));
    corner.refuseUnknown();
    List<Integer> runs = fields.integers("occupied", 2 * MAX_RUNS);
    if (!fields.errors().isEmpty()) {
      return new OccupancyGrid(1, 1, 1, Vec2.ZERO, new BitSet());
    }
    return new OccupancyGrid(width, height, resolution, origin, cells(runs, width * height));
  }

  /** Metres of a cell's side; 1 where it is refused. */
  static double resolution(JsonFields fields) {
    Double given = fields.number("resolution");
    if (given == null || !(given >= MapLimits.FINEST && given <= MapLimits.COARSEST)) {
      refuse(fields, "resolution", "error.drawing.resolution");
      return 1;
    }
    return given;
  }

  private static int size(@Nullable Double given) {
    return given != null && given == Math.rint(given) && given >= 1 && given <= MapLimits.MAX_CELLS
        ? given.intValue()
        : 0;
  }

  private BitSet cells(List<Integer> runs, int count) {
    BitSet occupied = new BitSet(count);
    long end = 0;
    boolean isWrong = runs.size() % 2 != 0;
    for (int i = 0; i + 1 < runs.size() && !isWrong; i += 2) {
      int from = runs.get(i);
      int length = runs.get(i + 1);
      isWrong = from < end || length < 1 || (long) from + length > count;
      if (!isWrong) {
        end = (long) from + length;
        occupied.set(from, from + length);
      }
    }
    if (isWrong) {
      refuse(fields, "occupied", "error.drawing.runs", count);
    }
    return occupied;
  }

  private List<Place> places(String kind) {
    List<Place> places = new ArrayList<>();
    for (JsonFields item : fields.objects(kind, FloorLimits.MOST_OF_A_KIND)) {
      String name = Optional.ofNullable(item.text("name")).orElse("").strip();
      Vec2 position = new Vec2(metres(item, "x"), metres(item, "y"));
      if (!FloorLimits.isName(name)) {
        int longest = FloorLimits.LONGEST_NAME;
        refuse(item, "name", "error.drawing.name", longest, position.x(), position.y());
      } else if (!names.add(name)) {
        refuse(item, "name", "error.drawing.nameTwice", name);
      }
      Direction approach = item.has("approach") ? optionalDirection(item) : null;
      places.add(new Place(name, position, heading(item), approach));
      item.refuseUnknown();
    }
    return places;
  }

  private static @Nullable Direction optionalDirection(JsonFields item) {
    return item.text("approach") == null ? null : direction(item, "approach");
  }

  private static @Nullable Double heading(JsonFields item) {
    Double degrees = item.number("headingDegrees");
    if (degrees == null) {
      return null;
    }
    if (!(Math.abs(degrees) <= 360)) {
      refuse(item, "headingDegrees", "error.drawing.heading");
      return 0.0;
    }
    return Angles.normalise(Math.toRadians(degrees));
  }

  private <T> List<T> areas(String kind, BiFunction<JsonFields, Area, T> reader) {
    List<T> areas = new ArrayList<>();
    for (JsonFields item : fields.objects(kind, FloorLimits.MOST_OF_A_KIND)) {
      Vec2 low = new Vec2(metres(item, "x"), metres(item, "y"));
      areas.add(reader.apply(item, new Area(low, side(item, "width"), side(item, "height"))));
      item.refuseUnknown();
    }
    return areas;
  }

  /** Metres; 1 where it is refused. */
  private static double side(JsonFields item, String name) {
    Double given = item.number(name);
    if (given == null || !(given > 0 && given <= 2 * MapLimits.FARTHEST)) {
      refuse(item, name, "error.drawing.side");
      return 1;
    }
    return given;
  }

  private static double speed(JsonFields item) {
    Double given = item.number("speed");
    if (given == null || !(given >= FloorLimits.SLOWEST && given <= FloorLimits.FASTEST)) {
      refuse(item, "speed", "error.drawing.speed", FloorLimits.SLOWEST, FloorLimits.FASTEST);
      return FloorLimits.FASTEST;
    }
    return given;
  }

  private static Direction direction(JsonFields item, String name) {
    String given = item.text(name);
    return Stream.ofNullable(given)
        .flatMap(word -> Direction.ofWord(word).stream())
        .findFirst()
        .orElseGet(
            () -> {
              refuse(item, name, "error.drawing.direction");
              return Direction.EAST;
            });
  }

  private static Moves moves(JsonFields fields) {
    String given = fields.text("moves");
    if (given == null) {
      return Moves.HEADING;
    }
    return Moves.ofWord(given)
        .orElseGet(
            () -> {
              refuse(fields, "moves", "error.drawing.moves");
              return Moves.HEADING;
            });
  }

  private static double metres(JsonFields item, String name) {
    Double given = item.number(name);
    if (given == null || !(Math.abs(given) <= MapLimits.FARTHEST)) {
      refuse(item, name, "error.drawing.metres", MapLimits.FARTHEST);
      return 0;
    }
    return given;
  }

  private static void refuse(JsonFields item, String name, String key, Object... values) {
    item.errors().add(item.path(name), item.texts().get(key, values));
  }
}
