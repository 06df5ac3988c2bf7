package org.toqa.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.MapFormatException;
import org.toqa.grid.MovingAiReader;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import org.toqa.grid.ScenarioReader;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/**
 * The files and numbers that a command is asked to use; what cannot be used is a wrong argument.
 */
public record Arguments(CommandSpec spec) {

  /**
   * What a command throws when an argument cannot be used: it exits 2.
   *
   * @param sentence what is wrong, for a person
   */
  public ParameterException invalid(String sentence) {
    return new ParameterException(spec.commandLine(), sentence);
  }

  /**
   * A MovingAI map, or the yaml file of a map_server pair.
   *
   * @throws ParameterException the file cannot be read, or is no map
   */
  public OccupancyGrid readGrid(Path file) {
    try {
      return file.toString().endsWith(".map")
          ? MovingAiReader.read(file)
          : FloorReader.read(file).grid();
    } catch (MapFormatException e) {
      throw invalid(String.valueOf(e.getMessage()));
    }
  }

  /**
   * A map of either kind, with its places and keep-out zones where it has some.
   *
   * @throws ParameterException the file cannot be read, or is no map
   */
  public FloorMap readFloor(Path file) {
    try {
      return FloorReader.read(file);
    } catch (MapFormatException e) {
      throw invalid(String.valueOf(e.getMessage()));
    }
  }

  /**
   * The queries of a scenario file.
   *
   * @throws ParameterException the file cannot be read, is no scenario, or is for a map of another
   *     size
   */
  public List<Scenario> readScenarios(Path file, OccupancyGrid map) {
    List<Scenario> all;
    try {
      all = ScenarioReader.read(file);
    } catch (MapFormatException e) {
      throw invalid(String.valueOf(e.getMessage()));
    }
    for (Scenario scenario : all) {
      if (scenario.width() != map.width() || scenario.height() != map.height()) {
        throw invalid(
            "%s is for a map of %d x %d cells, but the map has %d x %d"
                .formatted(file, scenario.width(), scenario.height(), map.width(), map.height()));
      }
    }
    return all;
  }

  /**
   * @throws ParameterException the file cannot be read
   */
  public List<String> readLines(Path file) {
    try {
      return Files.readAllLines(file);
    } catch (IOException e) {
      throw invalid(file + " cannot be read");
    }
  }

  /**
   * Fails before a measurement rather than after it.
   *
   * @throws ParameterException the file cannot be written
   */
  public void requireWritable(Path file) {
    Path folder = file.toAbsolutePath().getParent();
    if (folder == null || !Files.isWritable(folder) || Files.isDirectory(file)) {
      throw invalid(file + " must be a file in a folder that can be written");
    }
  }

  /**
   * Checks a number against its range.
   *
   * @param option such as {@code --robots}
   * @param least the smallest that is allowed
   * @param most the largest that is allowed
   * @throws ParameterException it is out of the range
   */
  public void requireBetween(String option, long value, long least, long most) {
    if (value < least || value > most) {
      throw invalid("%s %d: it must be from %d to %d".formatted(option, value, least, most));
    }
  }

  /**
   * The same for a number that need not be whole.
   *
   * @throws ParameterException it is out of the range
   */
  public void requireDecimalBetween(String option, double value, int least, int most) {
    if (!(value >= least && value <= most)) {
      throw invalid("%s %s: it must be from %d to %d".formatted(option, value, least, most));
    }
  }
}
