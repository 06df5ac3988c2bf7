package org.toqa.grid;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.toqa.geometry.Vec2;

/**
 * Reads a floor: its map, a ROS map_server {@code .yaml} or a MovingAI {@code .map}, and {@code
 * name.floor.yaml} beside it where there is one.
 *
 * <pre>
 * stations:                       # also parking, charging
 *   - {name: Packing, x: 1.65, y: 2.25}
 * keepOut:                        # lower left corner and size, metres
 *   - {x: 3.0, y: 4.2, width: 1.2, height: 0.6}
 * </pre>
 */
public final class FloorReader {
  private static final int LONGEST_NAME = 64;

  private FloorReader() {}

  public static FloorMap read(Path mapFile) throws MapFormatException {
    Path fileName = mapFile.getFileName();
    String file = fileName == null ? "" : fileName.toString();
    String lower = file.toLowerCase(Locale.ROOT);
    OccupancyGrid grid;
    if (lower.endsWith(".floor.yaml")) {
      throw new MapFormatException(
          mapFile + " only adds to a map; name the map's own .yaml or .map file.");
    } else if (lower.endsWith(".yaml")) {
      grid = MapServerReader.read(mapFile);
    } else if (lower.endsWith(".map")) {
      grid = MovingAiReader.read(mapFile);
    } else {
      throw new MapFormatException(
          mapFile + ": a map is a .yaml file (ROS map_server) or a .map file (MovingAI).");
    }
    String name = file.substring(0, file.lastIndexOf('.'));
    Path extra = mapFile.resolveSibling(name + ".floor.yaml");
    return Files.exists(extra)
        ? withPlaces(name, grid, extra)
        : new FloorMap(name, grid, List.of(), List.of(), List.of());
  }

  private static FloorMap withPlaces(String name, OccupancyGrid bare, Path file)
      throws MapFormatException {
    YamlFields yaml = YamlFields.read(file, List.of("stations", "parking", "charging", "keepOut"));
    OccupancyGrid grid = withoutKeepOut(bare, yaml);
    Set<String> names = new HashSet<>();
    return new FloorMap(
        name,
        grid,
        places(yaml, "stations", grid, names),
        places(yaml, "parking", grid, names),
        places(yaml, "charging", grid, names));
  }

  private static List<Place> places(
      YamlFields yaml, String key, OccupancyGrid grid, Set<String> names)
      throws MapFormatException {
    List<Place> places = new ArrayList<>();
    for (YamlFields item : yaml.items(key, List.of("name", "x", "y"))) {
      String name = item.text("name").strip();
      if (name.isEmpty()
          || name.length() > LONGEST_NAME
          || name.chars().anyMatch(Character::isISOControl)) {
        throw item.error("name", "must have 1 to " + LONGEST_NAME + " letters on one line.");
      }
      if (!names.add(name)) {
        throw item.error("name", "'" + name + "' is there twice; give each place its own.");
      }
      Vec2 position = new Vec2(item.metres("x"), item.metres("y"));
      if (!grid.isFree(position)) {
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
      places.add(new Place(name, position));
    }
    return places;
  }

  /** Occupies every cell that a keep-out rectangle overlaps. */
  private static OccupancyGrid withoutKeepOut(OccupancyGrid grid, YamlFields yaml)
      throws MapFormatException {
    BitSet occupied = grid.occupied();
    for (YamlFields zone : yaml.items("keepOut", List.of("x", "y", "width", "height"))) {
      Vec2 lowerLeft = new Vec2(zone.metres("x"), zone.metres("y"));
      for (String side : List.of("width", "height")) {
        if (!(zone.metres(side) > 0)) {
          throw zone.error(side, "must be larger than 0 m.");
        }
      }
      Vec2 upperRight = lowerLeft.plus(new Vec2(zone.metres("width"), zone.metres("height")));
      occupy(occupied, grid, lowerLeft, upperRight);
    }
    return grid.withOccupied(occupied);
  }

  private static void occupy(BitSet occupied, OccupancyGrid grid, Vec2 lowerLeft, Vec2 upperRight) {
    // a zone that ends on a cell's border does not reach into the next cell
    double rounding = grid.resolution() * 1e-6;
    Vec2 inset = new Vec2(rounding, rounding);
    Cell low = grid.cellAt(lowerLeft.plus(inset));
    Cell high = grid.cellAt(upperRight.minus(inset));
    for (int row = Math.max(0, high.row()); row <= low.row() && row < grid.height(); row++) {
      int from = Math.clamp(low.column(), 0, grid.width());
      int to = Math.clamp(high.column() + 1L, from, grid.width());
      occupied.set(row * grid.width() + from, row * grid.width() + to);
    }
  }
}
