package org.toqa.grid;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;

/**
 * Writes a floor as {@link FloorReader} reads it: a ROS map in the mode {@code trinary} and what is
 * added to it, or a MovingAI map, which has walls alone.
 */
public final class FloorWriter {
  private static final int FREE = 254;
  private static final int OCCUPIED = 0;

  private FloorWriter() {}

  /** All of the floor. */
  public static MapArchive mapServerFiles(String floor, FloorDrawing drawing) {
    String name = fileName(floor);
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put(name + ".yaml", text(mapYaml(name, drawing.walls())));
    files.put(name + ".pgm", picture(drawing.walls()));
    files.put(name + FloorReader.FLOOR_FILE, text(floorYaml(drawing)));
    return MapArchive.of(files);
  }

  /** Its walls, as drivable or not: {@code .} or {@code @}. */
  public static byte[] movingAi(FloorMap floor) {
    OccupancyGrid grid = floor.grid();
    StringBuilder map = new StringBuilder(grid.width() * grid.height() + 64);
    map.append("type octile\nheight ").append(grid.height());
    map.append("\nwidth ").append(grid.width()).append("\nmap\n");
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        map.append(grid.isFree(column, row) ? '.' : '@');
      }
      map.append('\n');
    }
    return text(map.toString());
  }

  /** A floor's name where files are called so. */
  public static String fileName(String floor) {
    String safe = floor.replaceAll("[^\\p{L}\\p{N}._ -]", "_").strip();
    return safe.isEmpty() || safe.startsWith(".") ? "floor" : safe;
  }

  private static byte[] text(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static String mapYaml(String name, OccupancyGrid grid) {
    return """
    image: %s
    resolution: %s
    origin: [%s, %s, 0]
    negate: 0
    occupied_thresh: 0.65
    free_thresh: 0.196
    """
        .formatted(quoted(name + ".pgm"), grid.resolution(), grid.origin().x(), grid.origin().y());
  }

  private static byte[] picture(OccupancyGrid grid) {
    byte[] header = text("P5\n" + grid.width() + " " + grid.height() + "\n255\n");
    ByteArrayOutputStream out =
        new ByteArrayOutputStream(header.length + grid.width() * grid.height());
    out.writeBytes(header);
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        out.write(grid.isFree(column, row) ? FREE : OCCUPIED);
      }
    }
    return out.toByteArray();
  }

  private static String floorYaml(FloorDrawing drawing) {
    StringBuilder yaml = new StringBuilder();
    list(yaml, FloorReader.STATIONS, drawing.stations(), FloorWriter::place);
    list(yaml, FloorReader.PARKING, drawing.parking(), FloorWriter::place);
    list(yaml, FloorReader.CHARGING, drawing.charging(), FloorWriter::place);
    list(yaml, FloorReader.KEEP_OUT, drawing.keepOut(), FloorWriter::area);
    list(
        yaml,
        FloorReader.SPEED_LIMITS,
        drawing.speedLimits(),
        limit -> area(limit.area()) + ", speed: " + limit.speed());
    list(
        yaml,
        FloorReader.ONE_WAY,
        drawing.oneWay(),
        oneWay -> area(oneWay.area()) + ", direction: " + oneWay.direction().word());
    list(yaml, FloorReader.FREE_ZONES, drawing.freeZones(), FloorWriter::area);
    if (drawing.moves() != Moves.HEADING) {
      yaml.append(FloorReader.MOVES).append(": ").append(drawing.moves().word()).append('\n');
    }
    return yaml.isEmpty() ? "stations: []\n" : yaml.toString();
  }

  private static <T> void list(
      StringBuilder yaml, String key, List<T> items, Function<T, String> fields) {
    if (!items.isEmpty()) {
      yaml.append(key).append(":\n");
      items.forEach(item -> yaml.append("  - {").append(fields.apply(item)).append("}\n"));
    }
  }

  private static String place(Place place) {
    StringBuilder fields = new StringBuilder("name: ").append(quoted(place.name()));
    fields.append(", x: ").append(place.position().x());
    fields.append(", y: ").append(place.position().y());
    if (place.heading() != null) {
      fields.append(", headingDegrees: ").append(Math.toDegrees(place.heading()));
    }
    if (place.approach() != null) {
      fields.append(", approach: ").append(place.approach().word());
    }
    return fields.toString();
  }

  private static String area(Area area) {
    return "x: %s, y: %s, width: %s, height: %s"
        .formatted(area.low().x(), area.low().y(), area.width(), area.height());
  }

  /** In double quotes, where YAML reads every letter that is written as it is escaped in JSON. */
  private static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    text.codePoints()
        .forEach(
            letter -> {
              if (letter == '"' || letter == '\\') {
                quoted.append('\\').appendCodePoint(letter);
              } else if (isPlain(letter)) {
                quoted.appendCodePoint(letter);
              } else {
                quoted.append(String.format(Locale.ROOT, "\\U%08x", letter));
              }
            });
    return quoted.append('"').toString();
  }

  /** Whether YAML readers take it in a quoted text as it is. */
  private static boolean isPlain(int letter) {
    return letter >= ' '
        && letter != 0x7F
        && !(letter >= 0x80 && letter < 0xA0)
        && letter != 0x2028
        && letter != 0x2029
        && letter != 0xFEFF
        && letter < 0xFFFE
        && !(letter >= 0xD800 && letter < 0xE000);
  }
}
