package org.toqa.web.input;

import java.util.BitSet;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorLimits;
import org.toqa.grid.MapLimits;
import org.toqa.grid.OccupancyGrid;

/** Reads what a new floor is called and how large it is. */
public final class FloorOrderReader {
  /** What an address of the API has in a floor's place. */
  private static final String RESERVED = "read";

  private FloorOrderReader() {}

  /** With nothing on it. */
  public static FloorOrder readEmpty(Fields fields) {
    String name = readName(fields);
    double resolution = metres(fields, "resolution", MapLimits.FINEST, MapLimits.COARSEST);
    long width = cells(fields, "width", resolution);
    long height = cells(fields, "height", resolution);
    fields.refuseUnknown();
    if (!fields.errors().isEmpty()) {
      return new FloorOrder(name, empty(1, 1, 1));
    }
    if (width * height > MapLimits.MAX_CELLS) {
      refuse(fields, "width", "error.floor.large", width, height, MapLimits.MAX_CELLS);
      return new FloorOrder(name, empty(1, 1, 1));
    }
    return new FloorOrder(name, empty((int) width, (int) height, resolution));
  }

  private static FloorDrawing empty(int width, int height, double resolution) {
    return FloorDrawing.of(new OccupancyGrid(width, height, resolution, Vec2.ZERO, new BitSet()));
  }

  /** A name that can stand in an address. */
  public static String readName(Fields fields) {
    String name = Optional.ofNullable(fields.text("name")).orElse("").strip();
    if (!FloorLimits.isFloorName(name) || name.equals(RESERVED)) {
      refuse(fields, "name", "error.floor.name", FloorLimits.LONGEST_NAME);
    }
    return name;
  }

  /** How many cells a side has; at least 1. */
  private static long cells(Fields fields, String side, double resolution) {
    double metres = metres(fields, side, MapLimits.FINEST, MapLimits.FARTHEST);
    return Math.max(1, Math.round(metres / resolution));
  }

  private static double metres(Fields fields, String name, double least, double most) {
    @Nullable Double given = fields.number(name);
    if (given == null || !(given >= least && given <= most)) {
      refuse(fields, name, "error.floor.metres", least, most);
      return 1;
    }
    return given;
  }

  private static void refuse(Fields fields, String name, String key, Object... values) {
    fields.errors().add(fields.path(name), fields.texts().get(key, values));
  }
}
