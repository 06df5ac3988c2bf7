package org.toqa.web.input;

import java.util.Locale;
import java.util.Map;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorPicture;
import org.toqa.grid.FloorReader;
import org.toqa.grid.MapArchive;
import org.toqa.grid.MapFormatException;

/** Files of a floor that somebody sends: a map as robots have it, or a plan of the floor. */
public final class FloorFiles {
  /** Bytes of all of them. */
  public static final int MAX_BYTES = 32 * 1024 * 1024;

  /** Metres that a pixel of a plan is wide, where nobody has said it. */
  public static final double USUAL_RESOLUTION = 0.05;

  /** What of a plan is a wall: all that is darker, from 0 black to 1 white. */
  public static final double USUAL_THRESHOLD = 0.5;

  /** Pieces of wall in all rows; more cannot be edited. */
  private static final int MAX_RUNS = 500_000;

  private FloorFiles() {}

  /**
   * What is drawn in them.
   *
   * @param files contents by their names: one ZIP file, one picture, a MovingAI map, or the files
   *     of a ROS map
   * @param resolution metres that a pixel of a picture is wide
   * @param threshold from 0 to 1: what of a picture is darker is a wall
   * @throws MapFormatException with file, place and remedy
   */
  public static FloorDrawing read(Map<String, byte[]> files, double resolution, double threshold)
      throws MapFormatException {
    FloorDrawing drawing = drawing(files, resolution, threshold);
    int runs = CellRuns.of(drawing.walls().occupied()).runs().size() / 2;
    if (runs > MAX_RUNS) {
      throw new MapFormatException(
          "The map has %d separate pieces of wall, more than %d; take specks out of the picture, or use another threshold."
              .formatted(runs, MAX_RUNS));
    }
    return drawing;
  }

  private static FloorDrawing drawing(
      Map<String, byte[]> files, double resolution, double threshold) throws MapFormatException {
    if (files.size() == 1) {
      Map.Entry<String, byte[]> file = files.entrySet().iterator().next();
      String name = file.getKey().toLowerCase(Locale.ROOT);
      if (name.endsWith(".zip")) {
        return FloorReader.read(MapArchive.unpack(file.getValue())).drawing();
      }
      if (name.endsWith(".png")) {
        return FloorPicture.read(file.getKey(), file.getValue(), resolution, threshold);
      }
    }
    return FloorReader.read(MapArchive.of(files)).drawing();
  }
}
