package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Path.Step;
import org.toqa.planning.PlanChecker.Rule;

class PlanCheckerTest {
  private static final OccupancyGrid GRID =
      OccupancyGrid.parse(
          "...", //
          ".#.", "...");

  private static Step step(int column, int row, Heading heading) {
    return new Step(new Cell(column, row), heading);
  }

  private static Optional<String> check(Rule rule, double cost, int turns, Step... steps) {
    Cell goal = steps[steps.length - 1].cell();
    Path path = new Path(List.of(steps), cost, turns);
    return PlanChecker.violation(GRID, new Cell(0, 0), goal, path, rule);
  }

  private static void assertRefused(String word, Optional<String> violation) {
    assertTrue(violation.isPresent() && violation.get().contains(word), violation::toString);
  }

  @Test
  void wayThatKeepsTheRulesIsAccepted() {
    assertEquals(
        Optional.empty(),
        check(
            Rule.HEADING,
            5, // 4 cells and 90 degrees
            1,
            step(0, 0, Heading.EAST),
            step(1, 0, Heading.EAST),
            step(2, 0, Heading.EAST),
            step(2, 0, Heading.SOUTH),
            step(2, 1, Heading.SOUTH),
            step(2, 2, Heading.SOUTH)));
  }

  @Test
  void sharpBendNeedsATurnOnTheSpotUnderTheHeadingRuleOnly() {
    Step[] steps = {
      step(0, 0, Heading.EAST),
      step(1, 0, Heading.EAST),
      step(2, 0, Heading.SOUTH),
      step(2, 1, Heading.SOUTH)
    };
    assertEquals(Optional.empty(), check(Rule.OCTILE, 3, 0, steps));
    assertRefused("bends by 90", check(Rule.HEADING, 3, 0, steps));
  }

  @Test
  void cutCornerIsRefused() {
    assertRefused(
        "no move",
        check(
            Rule.OCTILE,
            1 + Math.sqrt(2),
            0,
            step(0, 0, Heading.EAST),
            step(1, 0, Heading.SOUTH_EAST),
            step(2, 1, Heading.SOUTH_EAST)));
  }

  @Test
  void wallAndJumpAreRefused() {
    assertRefused(
        "no move",
        check(
            Rule.OCTILE,
            Math.sqrt(2),
            0,
            step(0, 0, Heading.SOUTH_EAST),
            step(1, 1, Heading.SOUTH_EAST)));
    assertRefused(
        "no move", check(Rule.OCTILE, 2, 0, step(0, 0, Heading.EAST), step(2, 0, Heading.EAST)));
  }

  @Test
  void wrongSumsAreRefused() {
    Step[] steps = {step(0, 0, Heading.EAST), step(1, 0, Heading.EAST)};
    assertRefused("costs", check(Rule.HEADING, 0.9, 0, steps));
    assertRefused("turns", check(Rule.HEADING, 1, 1, steps));
    assertRefused("costs", check(Rule.HEADING, Double.NaN, 0, steps));
  }

  @Test
  void wayElsewhereIsRefused() {
    assertRefused("lead", check(Rule.HEADING, 0, 0, step(1, 0, Heading.EAST)));
  }
}
