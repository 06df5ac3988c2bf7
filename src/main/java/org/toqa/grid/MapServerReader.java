package org.toqa.grid;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.function.DoublePredicate;
import org.toqa.geometry.Vec2;

/**
 * Reads the pair of files of ROS map_server: a YAML file that names a PGM or PNG picture and says
 * how its greys are meant, in one of its modes {@code trinary}, {@code scale} and {@code raw}. What
 * is not surely free is occupied: what the robot's map does not know, and all shades between.
 */
public final class MapServerReader {
  private static final List<String> KEYS =
      List.of("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode");

  private MapServerReader() {}

  public static OccupancyGrid read(Path yamlFile) throws MapFormatException {
    return read(MapFile.of(yamlFile));
  }

  static OccupancyGrid read(MapFile yamlFile) throws MapFormatException {
    YamlFields yaml = YamlFields.read(yamlFile, KEYS);
    double resolution = yaml.number("resolution");
    if (resolution < MapLimits.FINEST || resolution > MapLimits.COARSEST) {
      throw yaml.error("resolution", "metres of a cell's side, between 0.001 and 100.");
    }
    List<Double> origin = origin(yaml);
    Vec2 corner = new Vec2(origin.get(0), origin.get(1));
    DoublePredicate isFree = freeShades(yaml);
    String imageName = yaml.text("image");
    if (imageName.indexOf('\0') >= 0) {
      throw yaml.error("image", "must be the name of a file.");
    }
    GreyImage image = image(yamlFile.sibling(imageName), yaml);
    BitSet occupied = new BitSet(image.width() * image.height());
    for (int i = 0; i < image.width() * image.height(); i++) {
      occupied.set(i, !isFree.test(image.shades().at(i)));
    }
    OccupancyGrid grid =
        new OccupancyGrid(image.width(), image.height(), resolution, corner, occupied);
    return TurnedGrid.turn(yamlFile, grid, origin.get(2));
  }

  /** x, y and angle of the picture's lower left corner: metres and radians, map frame. */
  private static List<Double> origin(YamlFields yaml) throws MapFormatException {
    List<Double> origin = yaml.numbers("origin", 3);
    if (Math.max(Math.abs(origin.get(0)), Math.abs(origin.get(1))) > MapLimits.FARTHEST) {
      throw yaml.error(
          "origin", "x and y are metres, at most " + (long) MapLimits.FARTHEST + " from zero.");
    }
    if (Math.abs(origin.get(2)) > 2 * Math.PI) {
      throw yaml.error("origin", "the third number is an angle in radians, from -6.283 to 6.283.");
    }
    return origin;
  }

  /** Which shades are free; a transparent pixel is NaN, and so not below any threshold. */
  private static DoublePredicate freeShades(YamlFields yaml) throws MapFormatException {
    boolean negate = negate(yaml);
    double occupiedAbove = threshold(yaml, "occupied_thresh");
    double freeBelow = threshold(yaml, "free_thresh");
    if (freeBelow > occupiedAbove) {
      throw yaml.error("free_thresh", "must not be larger than occupied_thresh.");
    }
    String mode = yaml.has("mode") ? yaml.text("mode") : "trinary";
    return switch (mode) {
      case "trinary", "scale" -> shade -> (negate ? shade : 1 - shade) < freeBelow;
      // the pixel's value is how sure it is, in percent; above 100 it is not known
      case "raw" -> shade -> shade * 255 / 100 < freeBelow;
      default -> throw yaml.error("mode", "is 'trinary', 'scale' or 'raw', not '" + mode + "'.");
    };
  }

  private static boolean negate(YamlFields yaml) throws MapFormatException {
    double negate = yaml.has("negate") ? yaml.number("negate") : 0;
    if (negate != 0 && negate != 1) {
      throw yaml.error("negate", "must be 0 (dark is occupied) or 1 (light is occupied).");
    }
    return negate == 1;
  }

  private static double threshold(YamlFields yaml, String key) throws MapFormatException {
    double threshold = yaml.number(key);
    if (threshold < 0 || threshold > 1) {
      throw yaml.error(key, "must lie between 0 and 1, not " + threshold + ".");
    }
    return threshold;
  }

  private static GreyImage image(MapFile file, YamlFields yaml) throws MapFormatException {
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (name.endsWith(".pgm")) {
      return PgmReader.read(file);
    }
    if (name.endsWith(".png")) {
      return PngReader.read(file);
    }
    throw yaml.error("image", "must be a .pgm or .png file.");
  }
}
