package org.toqa.app.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.app.command.Arguments;
import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.RoadGraph;

/**
 * Where a robot begins, and its goals in order.
 *
 * <p>A file of them has a line a robot: the start as {@code column,row} or {@code column,row,H}
 * with H the heading, one of N E S W (E where it is left out), then the goals as {@code
 * column,row}, separated by blanks. Empty lines and what follows a {@code #} are ignored.
 */
record RobotGoals(GridPose start, List<Cell> goals) {
  private static final Map<String, Heading> HEADINGS =
      Map.of("N", Heading.NORTH, "E", Heading.EAST, "S", Heading.SOUTH, "W", Heading.WEST);

  RobotGoals {
    goals = List.copyOf(goals);
  }

  /**
   * A robot a line; each start once, all cells free, and each goal connected to its start.
   *
   * @throws picocli.CommandLine.ParameterException the file cannot be read, or a line is not so;
   *     names the line
   */
  static List<RobotGoals> read(Path file, RoadGraph roads, Arguments arguments) {
    List<RobotGoals> lists = new ArrayList<>();
    Map<Cell, Integer> starts = new HashMap<>();
    List<String> lines = arguments.readLines(file);
    for (int i = 0; i < lines.size(); i++) {
      String text = lines.get(i).replaceFirst("#.*", "").strip();
      if (text.isEmpty()) {
        continue;
      }
      int number = i + 1;
      RobotGoals list =
          parse(text, roads)
              .orElseThrow(
                  () ->
                      arguments.invalid(
                          "%s, line %d: expected a start and its goals, column,row each, on free cells that are connected"
                              .formatted(file, number)));
      Integer other = starts.put(list.start().cell(), number);
      if (other != null) {
        throw arguments.invalid(
            "%s, line %d: another robot starts there (line %d)".formatted(file, number, other));
      }
      lists.add(list);
    }
    if (lists.isEmpty()) {
      throw arguments.invalid(file + " names no robot");
    }
    return lists;
  }

  /** As in a file. */
  String line() {
    return Stream.concat(
            Stream.of(text(start.cell()) + "," + start.heading().name().charAt(0)),
            goals.stream().map(RobotGoals::text))
        .collect(Collectors.joining(" "));
  }

  private static String text(Cell cell) {
    return cell.column() + "," + cell.row();
  }

  private static Optional<RobotGoals> parse(String text, RoadGraph roads) {
    List<String> words = List.of(text.split("\\s+"));
    String[] first = words.getFirst().split(",", -1);
    Heading heading = first.length == 3 ? HEADINGS.get(first[2]) : Heading.EAST;
    Optional<Cell> start =
        first.length < 2 ? Optional.empty() : cell(first[0] + "," + first[1], roads);
    List<Cell> goals = words.stream().skip(1).flatMap(word -> cell(word, roads).stream()).toList();
    if (first.length > 3 || heading == null || start.isEmpty()) {
      return Optional.empty();
    }
    int from = roads.vertex(start.get());
    boolean isWhole = goals.size() == words.size() - 1;
    boolean isConnected = goals.stream().allMatch(goal -> roads.canReach(from, roads.vertex(goal)));
    return isWhole && isConnected
        ? Optional.of(new RobotGoals(new GridPose(start.get(), heading), goals))
        : Optional.empty();
  }

  /** A free cell. */
  private static Optional<Cell> cell(String word, RoadGraph roads) {
    if (!word.matches("\\d{1,6},\\d{1,6}")) {
      return Optional.empty();
    }
    int[] numbers = Stream.of(word.split(",", -1)).mapToInt(Integer::parseInt).toArray();
    Cell cell = new Cell(numbers[0], numbers[1]);
    return roads.vertex(cell) == RoadGraph.NONE ? Optional.empty() : Optional.of(cell);
  }
}
