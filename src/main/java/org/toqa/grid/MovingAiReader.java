package org.toqa.grid;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * Reads maps of the MovingAI benchmarks (Sturtevant, "Benchmarks for Grid-Based Pathfinding",
 * 2012): {@code type octile}, height, width, {@code map}, then the rows. '.', 'G' and 'S' are
 * passable. Cells are 1 m, the lower left corner is (0, 0).
 */
public final class MovingAiReader {
  private static final int HEADER = 4;

  private MovingAiReader() {}

  public static OccupancyGrid read(Path file) throws MapFormatException {
    return read(MapFile.of(file));
  }

  static OccupancyGrid read(MapFile file) throws MapFormatException {
    List<String> lines = file.readLines(MapLimits.MAX_MAP_BYTES);
    expect(file, lines, 0, "type octile");
    int height = size(file, lines, 1, "height");
    int width = size(file, lines, 2, "width");
    expect(file, lines, 3, "map");
    MapLimits.checkSize(file, width, height);
    BitSet occupied = new BitSet(width * height);
    for (int row = 0; row < height; row++) {
      String cells = line(lines, HEADER + row);
      if (cells.length() != width) {
        throw new MapFormatException(
            "%s, line %d: the row has %d cells, not the %d of the header."
                .formatted(file, HEADER + row + 1, cells.length(), width));
      }
      for (int column = 0; column < width; column++) {
        occupied.set(row * width + column, ".GS".indexOf(cells.charAt(column)) < 0);
      }
    }
    return new OccupancyGrid(width, height, 1, Vec2.ZERO, occupied);
  }

  private static String line(List<String> lines, int index) {
    return index < lines.size() ? lines.get(index) : "";
  }

  private static void expect(MapFile file, List<String> lines, int index, String text)
      throws MapFormatException {
    if (!line(lines, index).strip().equals(text)) {
      throw new MapFormatException(
          "%s, line %d: expected '%s'; is this a MovingAI map?".formatted(file, index + 1, text));
    }
  }

  private static int size(MapFile file, List<String> lines, int index, String key)
      throws MapFormatException {
    String[] words = line(lines, index).strip().split("\\s+", -1);
    if (words.length == 2 && words[0].equals(key) && words[1].matches("\\d{1,9}")) {
      return Integer.parseInt(words[1]);
    }
    throw new MapFormatException(
        "%s, line %d: expected '%s' and a number.".formatted(file, index + 1, key));
  }
}
