package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.grid.Cell;
import org.toqa.grid.MovingAiReader;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import org.toqa.grid.ScenarioReader;
import org.toqa.planning.PlanChecker.Rule;
import org.toqa.planning.PlanResult.Found;
import org.toqa.testbed.Tally;

/**
 * The planners against lengths that other programs found, on MovingAI maps that do not ship with
 * the product: the folder that holds {@code data/grid} is the system property {@code toqa.shared}.
 * Where it is not there, the maps are made here, and {@link ReferenceSearch} finds the lengths.
 */
@Tag("full")
class KnownAnswersTest {
  private static final Path FOLDER =
      Path.of(System.getProperty("toqa.shared", "../shared"), "data", "grid");
  private static final int EVERY = 6;

  /**
   * @param length in cells; negative where only turns on the spot lead to the goal
   */
  private record Answer(String name, OccupancyGrid grid, Cell start, Cell goal, double length) {
    @Override
    public String toString() {
      return name + ": " + start + " to " + goal;
    }
  }

  @Test
  void headingWaysAreAsShortAsTheKnownOnes() throws IOException {
    List<Answer> answers =
        Files.isDirectory(FOLDER)
            ? headingAnswers()
            : OwnMaps.queries().map(query -> ownAnswer(query, ReferenceSearch.ARCS_ONLY)).toList();
    assertAsShort(new HeadingAStar(), Rule.HEADING, answers);
  }

  @Test
  void octileWaysAreAsShortAsTheKnownOnes() throws IOException {
    List<Answer> answers =
        Files.isDirectory(FOLDER)
            ? octileAnswers()
            : OwnMaps.queries().map(query -> ownAnswer(query, ReferenceSearch.FREE)).toList();
    assertAsShort(new JumpPointSearch(), Rule.OCTILE, answers);
  }

  private static void assertAsShort(PathPlanner planner, Rule rule, List<Answer> answers) {
    assertTrue(answers.size() >= 100, () -> "only " + answers.size() + " known answers");
    for (Answer known : answers) {
      String what = known.toString();
      Found found =
          assertInstanceOf(
              Found.class, planner.plan(known.grid(), known.start(), known.goal()), what);
      assertEquals(
          Optional.empty(),
          PlanChecker.violation(known.grid(), known.start(), known.goal(), found.path(), rule),
          what);
      assertEquals(known.length() < 0, found.path().turnsOnSpot() > 0, what);
      if (known.length() >= 0) {
        assertEquals(known.length(), found.path().cost(), 1e-4 * known.length(), what);
      }
    }
    Tally.add("paths of known length", answers.size());
  }

  private static Answer ownAnswer(RandomGrids.Query query, ReferenceSearch.TurnCost turns) {
    double length =
        ReferenceSearch.shortest(query.grid(), query.start(), query.goal(), turns).orElse(-1);
    return new Answer("a map of its own", query.grid(), query.start(), query.goal(), length);
  }

  private static List<Answer> headingAnswers() throws IOException {
    List<String> lines = Files.readAllLines(FOLDER.resolve("heading-optimal.tsv"));
    Map<String, OccupancyGrid> grids = new HashMap<>();
    List<Answer> answers = new ArrayList<>();
    for (String line : lines.stream().skip(1).toList()) {
      String[] columns = line.split("\t", -1);
      if (Integer.parseInt(columns[1]) % EVERY != 0) {
        continue;
      }
      if (!grids.containsKey(columns[0])) {
        grids.put(columns[0], MovingAiReader.read(FOLDER.resolve(columns[0] + ".map")));
      }
      Cell start = new Cell(Integer.parseInt(columns[2]), Integer.parseInt(columns[3]));
      Cell goal = new Cell(Integer.parseInt(columns[4]), Integer.parseInt(columns[5]));
      double length = Double.parseDouble(columns[7]);
      answers.add(new Answer(columns[0], grids.get(columns[0]), start, goal, length));
    }
    return answers;
  }

  private static List<Answer> octileAnswers() throws IOException {
    List<Answer> answers = new ArrayList<>();
    for (String name :
        List.of("32room_000", "maze512-8-0", "random512-10-0", "warehouse-20-40-10-2-2")) {
      OccupancyGrid grid = MovingAiReader.read(FOLDER.resolve(name + ".map"));
      List<Scenario> scenarios = ScenarioReader.read(FOLDER.resolve(name + ".map.scen"));
      for (int i = 0; i < scenarios.size(); i += EVERY) {
        Scenario query = scenarios.get(i);
        answers.add(new Answer(name, grid, query.start(), query.goal(), query.optimal()));
      }
    }
    return answers;
  }
}
