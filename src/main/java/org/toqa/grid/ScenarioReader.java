package org.toqa.grid;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads scenario files of the MovingAI benchmarks: a line {@code version 1}, then one query a line
 * in nine columns: bucket, map, width, height, start column and row, goal column and row, optimal
 * length.
 */
public final class ScenarioReader {
  private static final int COLUMNS = 9;

  private ScenarioReader() {}

  public static List<Scenario> read(Path file) throws MapFormatException {
    List<String> lines = MapFile.of(file).readLines(MapLimits.MAX_MAP_BYTES);
    if (lines.isEmpty() || !lines.getFirst().strip().matches("version\\s+1(\\.0)?")) {
      throw new MapFormatException(
          file + ", line 1: expected 'version 1'; is this a MovingAI scenario?");
    }
    List<Scenario> scenarios = new ArrayList<>();
    for (int i = 1; i < lines.size(); i++) {
      if (!lines.get(i).isBlank()) {
        scenarios.add(scenario(lines.get(i), "%s, line %d".formatted(file, i + 1)));
      }
    }
    return List.copyOf(scenarios);
  }

  private static Scenario scenario(String line, String place) throws MapFormatException {
    String[] words = line.strip().split(line.contains("\t") ? "\t" : "\\s+", -1);
    if (words.length != COLUMNS) {
      throw new MapFormatException(
          "%s: %d columns instead of %d.".formatted(place, words.length, COLUMNS));
    }
    try {
      Scenario scenario =
          new Scenario(
              Integer.parseInt(words[0]),
              words[1],
              Integer.parseInt(words[2]),
              Integer.parseInt(words[3]),
              new Cell(Integer.parseInt(words[4]), Integer.parseInt(words[5])),
              new Cell(Integer.parseInt(words[6]), Integer.parseInt(words[7])),
              Double.parseDouble(words[8]));
      if (isOff(scenario, scenario.start()) || isOff(scenario, scenario.goal())) {
        throw new MapFormatException(place + ": start or goal lies off the map.");
      }
      return scenario;
    } catch (NumberFormatException e) {
      throw new MapFormatException(place + ": a column that must be a number is not.", e);
    }
  }

  private static boolean isOff(Scenario scenario, Cell cell) {
    return cell.column() < 0
        || cell.row() < 0
        || cell.column() >= scenario.width()
        || cell.row() >= scenario.height();
  }
}
