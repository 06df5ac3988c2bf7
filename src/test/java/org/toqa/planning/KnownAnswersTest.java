package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.toqa.grid.Cell;
import org.toqa.grid.MovingAiReader;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import org.toqa.grid.ScenarioReader;
import org.toqa.planning.PlanChecker.Rule;
import org.toqa.planning.PlanResult.Found;

/**
 * The planners against lengths that other programs found, on MovingAI maps that do not ship with
 * the product. The folder that holds {@code data/grid} is the system property {@code toqa.shared}.
 */
class KnownAnswersTest {
  private static final Path FOLDER =
      Path.of(System.getProperty("toqa.shared", "../shared"), "data", "grid");
  private static final int EVERY = 6;

  @BeforeAll
  static void folderIsThere() {
    assumeTrue(
        Files.isDirectory(FOLDER),
        () -> "There is no folder " + FOLDER + "; name it with -Dtoqa.shared=FOLDER.");
  }

  @Test
  void headingWaysAreAsShortAsTheKnownOnes() throws IOException {
    List<String> lines = Files.readAllLines(FOLDER.resolve("heading-optimal.tsv"));
    PathPlanner planner = new HeadingAStar();
    Map<String, OccupancyGrid> grids = new HashMap<>();
    for (String line : lines.stream().skip(1).toList()) {
      String[] columns = line.split("\t", -1);
      if (Integer.parseInt(columns[1]) % EVERY != 0) {
        continue;
      }
      if (!grids.containsKey(columns[0])) {
        grids.put(columns[0], MovingAiReader.read(FOLDER.resolve(columns[0] + ".map")));
      }
      OccupancyGrid grid = grids.get(columns[0]);
      Cell start = new Cell(Integer.parseInt(columns[2]), Integer.parseInt(columns[3]));
      Cell goal = new Cell(Integer.parseInt(columns[4]), Integer.parseInt(columns[5]));
      Found found = assertInstanceOf(Found.class, planner.plan(grid, start, goal), line);
      assertEquals(
          Optional.empty(),
          PlanChecker.violation(grid, start, goal, found.path(), Rule.HEADING),
          line);
      double known = Double.parseDouble(columns[7]);
      assertEquals(known < 0, found.path().turnsOnSpot() > 0, line);
      if (known >= 0) {
        assertEquals(known, found.path().cost(), 1e-4 * known, line);
      }
    }
  }

  @Test
  void octileWaysAreAsShortAsTheScenariosSay() throws IOException {
    PathPlanner planner = new JumpPointSearch();
    for (String name :
        List.of("32room_000", "maze512-8-0", "random512-10-0", "warehouse-20-40-10-2-2")) {
      OccupancyGrid grid = MovingAiReader.read(FOLDER.resolve(name + ".map"));
      List<Scenario> scenarios = ScenarioReader.read(FOLDER.resolve(name + ".map.scen"));
      for (int i = 0; i < scenarios.size(); i += EVERY) {
        Scenario query = scenarios.get(i);
        Found found =
            assertInstanceOf(
                Found.class, planner.plan(grid, query.start(), query.goal()), query.toString());
        assertEquals(
            Optional.empty(),
            PlanChecker.violation(grid, query.start(), query.goal(), found.path(), Rule.OCTILE),
            query.toString());
        assertEquals(query.optimal(), found.path().cost(), 1e-4 * query.optimal());
      }
    }
  }
}
