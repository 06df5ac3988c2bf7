package org.toqa.grid;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import org.toqa.geometry.Vec2;

/**
 * Reads the pair of files of ROS map_server: a YAML file that names a PGM or PNG picture and says
 * how its greys are meant. Only mode {@code trinary}; a cell that the robot's map does not know is
 * occupied.
 */
public final class MapServerReader {
  private static final List<String> KEYS =
      List.of("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode");

  private MapServerReader() {}

  public static OccupancyGrid read(Path yamlFile) throws MapFormatException {
    YamlFields yaml = YamlFields.read(yamlFile, KEYS);
    String mode = yaml.has("mode") ? yaml.text("mode") : "trinary";
    if (!mode.equals("trinary")) {
      throw yaml.error("mode", "only 'trinary' is supported, not '" + mode + "'.");
    }
    double resolution = yaml.number("resolution");
    if (resolution < 0.001 || resolution > 100) {
      throw yaml.error("resolution", "metres of a cell's side, between 0.001 and 100.");
    }
    Vec2 origin = origin(yaml);
    boolean negate = negate(yaml);
    double occupiedAbove = threshold(yaml, "occupied_thresh");
    double freeBelow = threshold(yaml, "free_thresh");
    if (freeBelow > occupiedAbove) {
      throw yaml.error("free_thresh", "must not be larger than occupied_thresh.");
    }
    GreyImage image = image(yamlFile.resolveSibling(yaml.text("image")), yaml);
    BitSet occupied = new BitSet(image.width() * image.height());
    for (int i = 0; i < image.width() * image.height(); i++) {
      double shade = image.shades().at(i);
      double occupancy = negate ? shade : 1 - shade;
      // a transparent pixel is NaN: not below any threshold, so occupied
      occupied.set(i, !(occupancy < freeBelow));
    }
    return new OccupancyGrid(image.width(), image.height(), resolution, origin, occupied);
  }

  private static Vec2 origin(YamlFields yaml) throws MapFormatException {
    List<Double> origin = yaml.numbers("origin", 3);
    if (origin.get(2) != 0) {
      throw yaml.error(
          "origin",
          "a map turned by "
              + origin.get(2)
              + " rad is not supported; turn the picture"
              + " and write 0.");
    }
    if (Math.max(Math.abs(origin.get(0)), Math.abs(origin.get(1))) > MapLimits.FARTHEST) {
      throw yaml.error(
          "origin", "x and y are metres, at most " + (long) MapLimits.FARTHEST + " from zero.");
    }
    return new Vec2(origin.get(0), origin.get(1));
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

  private static GreyImage image(Path file, YamlFields yaml) throws MapFormatException {
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
