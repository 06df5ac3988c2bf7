package org.toqa.grid;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;

/**
 * Reads a floor: its map, a ROS map_server {@code .yaml} or a MovingAI {@code .map}, and {@code
 * name.floor.yaml} beside it where there is one.
 *
 * <pre>
 * stations:                       # also parking, charging
 *   - {name: Packing, x: 1.65, y: 2.25, headingDegrees: 90, approach: north}
 * keepOut:                        # lower left corner and size, metres
 *   - {x: 3.0, y: 4.2, width: 1.2, height: 0.6}
 * speedLimits:                    # metres a second
 *   - {x: 3.0, y: 5.0, width: 1.2, height: 0.6, speed: 0.2}
 * oneWay:                         # east, north, west or south
 *   - {x: 3.0, y: 6.0, width: 1.2, height: 0.6, direction: east}
 * freeZones:                      # given to one robot as a whole
 *   - {x: 3.0, y: 7.0, width: 2.4, height: 2.4}
 * moves: smooth                   # or heading, as where nothing is said
 * </pre>
 */
public final class FloorReader {
  static final String FLOOR_FILE = ".floor.yaml";
  static final String STATIONS = "stations";
  static final String PARKING = "parking";
  static final String CHARGING = "charging";
  static final String KEEP_OUT = "keepOut";
  static final String SPEED_LIMITS = "speedLimits";
  static final String ONE_WAY = "oneWay";
  static final String FREE_ZONES = "freeZones";
  static final String MOVES = "moves";

  private FloorReader() {}

  public static FloorMap read(Path mapFile) throws MapFormatException {
    return read(MapFile.of(mapFile));
  }

  /** The floor whose files are packed together; it is called as its map's file. */
  public static FloorMap read(MapArchive archive) throws MapFormatException {
    return read(archive.main());
  }

  /**
   * The same drawing as it was stored: places may also lie in walls or off the map, as while it is
   * drawn, and are called as was allowed when they were named.
   */
  public static FloorDrawing readStored(MapArchive archive) throws MapFormatException {
    return read(archive.main(), true).drawing();
  }

  private static FloorMap read(MapFile mapFile) throws MapFormatException {
    return read(mapFile, false);
  }

  private static FloorMap read(MapFile mapFile, boolean isStored) throws MapFormatException {
    String file = mapFile.name();
    String lower = file.toLowerCase(Locale.ROOT);
    OccupancyGrid grid;
    if (lower.endsWith(FLOOR_FILE) && !floorFile(mapFile).exists()) {
      throw new MapFormatException(
          mapFile + " only adds to a map; name the map's own .yaml or .map file.");
    } else if (lower.endsWith(".yaml") || lower.endsWith(".yml")) {
      grid = MapServerReader.read(mapFile);
    } else if (lower.endsWith(".map")) {
      grid = MovingAiReader.read(mapFile);
    } else {
      throw new MapFormatException(
          mapFile + ": a map is a .yaml file (ROS map_server) or a .map file (MovingAI).");
    }
    String name = file.substring(0, file.lastIndexOf('.'));
    MapFile extra = floorFile(mapFile);
    FloorDrawing drawing =
        extra.exists() ? withPlaces(grid, extra, isStored) : FloorDrawing.of(grid);
    return new FloorMap(name, drawing, Margins.USUAL);
  }

  /** What adds to a map's file, whether or not there is one. */
  static MapFile floorFile(MapFile mapFile) {
    String file = mapFile.name();
    return mapFile.sibling(file.substring(0, file.lastIndexOf('.')) + FLOOR_FILE);
  }

  private static FloorDrawing withPlaces(OccupancyGrid walls, MapFile file, boolean isStored)
      throws MapFormatException {
    YamlFields yaml =
        YamlFields.read(
            file,
            List.of(
                STATIONS, PARKING, CHARGING, KEEP_OUT, SPEED_LIMITS, ONE_WAY, FREE_ZONES, MOVES),
            isStored ? MapLimits.MAX_STORED_YAML_BYTES : MapLimits.MAX_YAML_BYTES);
    List<Area> keepOut = new ArrayList<>();
    for (YamlFields zone : items(yaml, KEEP_OUT)) {
      keepOut.add(area(zone));
    }
    List<SpeedLimit> speedLimits = new ArrayList<>();
    for (YamlFields zone : items(yaml, SPEED_LIMITS, "speed")) {
      speedLimits.add(new SpeedLimit(area(zone), speed(zone)));
    }
    List<OneWay> oneWay = new ArrayList<>();
    for (YamlFields zone : items(yaml, ONE_WAY, "direction")) {
      oneWay.add(new OneWay(area(zone), direction(zone, "direction")));
    }
    List<Area> freeZones = new ArrayList<>();
    for (YamlFields zone : items(yaml, FREE_ZONES)) {
      freeZones.add(area(zone));
    }
    @Nullable OccupancyGrid drivable =
        isStored
            ? null
            : new FloorDrawing(
                    walls, List.of(), List.of(), List.of(), keepOut, List.of(), List.of())
                .drivable();
    Set<String> names = new HashSet<>();
    return new FloorDrawing(
        walls,
        places(yaml, STATIONS, drivable, names),
        places(yaml, PARKING, drivable, names),
        places(yaml, CHARGING, drivable, names),
        keepOut,
        speedLimits,
        oneWay,
        freeZones,
        moves(yaml));
  }

  private static Moves moves(YamlFields yaml) throws MapFormatException {
    if (!yaml.has(MOVES)) {
      return Moves.HEADING;
    }
    String word = yaml.text(MOVES);
    return Moves.ofWord(word)
        .orElseThrow(
            () ->
                yaml.error(
                    MOVES,
                    "is one of " + String.join(", ", Moves.words()) + ", not '" + word + "'."));
  }

  private static List<YamlFields> items(YamlFields yaml, String key, String... more)
      throws MapFormatException {
    List<String> known = new ArrayList<>(List.of("x", "y", "width", "height"));
    known.addAll(List.of(more));
    return yaml.items(key, known);
  }

  private static Area area(YamlFields zone) throws MapFormatException {
    for (String side : List.of("width", "height")) {
      if (!(zone.metres(side) > 0)) {
        throw zone.error(side, "must be larger than 0 m.");
      }
    }
    return new Area(
        new Vec2(zone.metres("x"), zone.metres("y")), zone.metres("width"), zone.metres("height"));
  }

  private static double speed(YamlFields zone) throws MapFormatException {
    double speed = zone.number("speed");
    if (speed < FloorLimits.SLOWEST || speed > FloorLimits.FASTEST) {
      throw zone.error(
          "speed",
          "is in metres a second, from "
              + FloorLimits.SLOWEST
              + " to "
              + FloorLimits.FASTEST
              + ".");
    }
    return speed;
  }

  private static Direction direction(YamlFields item, String key) throws MapFormatException {
    String word = item.text(key);
    return Direction.ofWord(word)
        .orElseThrow(
            () ->
                item.error(
                    key,
                    "is one of "
                        + Arrays.stream(Direction.values())
                            .map(Direction::word)
                            .collect(Collectors.joining(", "))
                        + ", not '"
                        + word
                        + "'."));
  }

  /**
   * @param grid on whose free cells they must lie; null: they may lie anywhere, and are called as
   *     they are
   */
  private static List<Place> places(
      YamlFields yaml, String key, @Nullable OccupancyGrid grid, Set<String> names)
      throws MapFormatException {
    List<Place> places = new ArrayList<>();
    for (YamlFields item :
        yaml.items(key, List.of("name", "x", "y", "headingDegrees", "approach"))) {
      String name = item.text("name").strip();
      if (grid != null && !FloorLimits.isName(name)) {
        throw item.error(
            "name",
            "must have 1 to "
                + FloorLimits.LONGEST_NAME
                + " letters on one line, all of which can be shown.");
      }
      if (!names.add(name)) {
        throw item.error("name", "'" + name + "' is there twice; give each place its own.");
      }
      Vec2 position = new Vec2(item.metres("x"), item.metres("y"));
      if (grid != null && !grid.isFree(position)) {
        boolean offMap = !grid.contains(grid.cellAt(position));
        throw item.error(
            "x",
            "'%s' at (%s, %s) lies %s; move it to a free cell."
                .formatted(
                    name,
                    position.x(),
                    position.y(),
                    offMap ? "off the map" : "in a wall or a keep-out zone"));
      }
      Direction approach = item.has("approach") ? direction(item, "approach") : null;
      places.add(new Place(name, position, heading(item), approach));
    }
    return places;
  }

  private static @Nullable Double heading(YamlFields item) throws MapFormatException {
    if (!item.has("headingDegrees")) {
      return null;
    }
    double degrees = item.number("headingDegrees");
    if (Math.abs(degrees) > 360) {
      throw item.error("headingDegrees", "lies between -360 and 360.");
    }
    return Angles.normalise(Math.toRadians(degrees));
  }
}
