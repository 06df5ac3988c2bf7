package org.toqa.allocation;

import static java.util.stream.Collectors.toMap;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.allocation.Floors.NOON;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.wording.Sentence;

class OptimalAllocatorTest {
  private static final String LEAST = " m from the load; least total energy for all tasks";
  private final Allocator allocator = new OptimalAllocator();

  @Test
  void looksAtAllTasksBeforeItGivesAwayTheNearestRobot() {
    // in turn: r2 to task 1 (2 m), r1 to task 2 (9 m); together: r1 to 1 (4 m), r2 to 2 (3 m)
    assertEquals(
        List.of(
            new Decision.Assigned(
                1,
                List.of("r1"),
                Sentence.verbatim("4.0" + LEAST + " (2 to assign, 2 robots free)")),
            new Decision.Assigned(
                2,
                List.of("r2"),
                Sentence.verbatim("3.0" + LEAST + " (2 to assign, 2 robots free)"))),
        Outcome.inEnglish(
            allocator.allocate(
                situation(
                    List.of(job(1, 5, 4), job(2, 5, 9)),
                    List.of(free("r1", 5, 0), free("r2", 5, 6))))));
  }

  @Test
  void noOtherAllocatorGivesAsManyTasksForLess() {
    int cheaper = 0;
    for (int seed = 0; seed < 200; seed++) {
      AllocationProblem problem = Floors.random(seed, 4, 12, 0);
      if (problem.waiting().stream().anyMatch(t -> TeamSize.isForSeveral(problem, t))) {
        continue;
      }
      Outcome optimal = new Outcome(problem, allocator.allocate(problem));
      for (Allocator other :
          List.of(new NearestFreeRobot(), new ZoneAllocator(), new NegotiatedAllocator())) {
        Outcome outcome = new Outcome(problem, other.allocate(problem));
        String where = "seed " + seed + ": " + other.getClass().getSimpleName();
        assertTrue(optimal.holders.size() >= outcome.holders.size(), where);
        if (optimal.holders.keySet().equals(outcome.holders.keySet())) {
          assertTrue(optimal.joules() <= outcome.joules() + 1e-6, where);
          cheaper += optimal.joules() < outcome.joules() - 1e-6 ? 1 : 0;
        }
      }
    }
    assertTrue(cheaper > 100, "it was cheaper " + cheaper + " times only");
  }

  /** A team of the nearest, r2 and r3, would leave a long path to the one that carries 1 kg. */
  @Test
  void theTeamIsPartOfTheOneDecision() {
    List<Decision> decisions =
        allocator.allocate(
            situation(
                List.of(job(1, 8, 8), job(2, 1, 11)),
                List.of(free("r1", 5, 2), free("r2", 5, 10), free("r3", 5, 13))));
    assertEquals(
        Map.of(1L, List.of("r2", "r1"), 2L, List.of("r3")),
        decisions.stream().collect(toMap(Decision::task, Outcome::robots)));
  }

  /**
   * Of all ways to deal them out, tried one by one, none has more robots at work, or costs less.
   */
  @Test
  void noWayToGiveThemOutIsBetter() {
    int together = 0;
    for (int seed = 0; seed < 60; seed++) {
      AllocationProblem problem = Floors.random(seed, 1 + seed % 4, 3 + seed % 4, 0);
      List<Decision> decisions = allocator.allocate(problem);
      TriedOneByOne best = new TriedOneByOne(problem);
      boolean isSearched = best.isWithoutPrecedence();
      together += decisions.stream().anyMatch(d -> Outcome.robots(d).size() > 1) ? 1 : 0;
      if (isSearched) {
        best.assertNoneIsBetterThan(decisions, "seed " + seed);
      }
    }
    assertTrue(together > 10, "several together " + together + " times only");
  }

  @Test
  void aRobotOnItsWayIsTurnedRoundOnlyWhereThatIsWorthIt() {
    GivenTask given = new GivenTask(job(1, 5, 10), "r1");

    assertEquals(List.of(), withFreeRobotAt(6, given)); // 4 m instead of 5 m
    assertEquals(
        List.of(
            new Decision.Assigned(
                1,
                List.of("r2"),
                Sentence.verbatim(
                    "1.0" + LEAST + " (0 to assign, 1 robot free), taken over from r1"))),
        Outcome.inEnglish(withFreeRobotAt(9, given)));
  }

  private List<Decision> withFreeRobotAt(double x, GivenTask given) {
    return allocator.allocate(
        situation(NOON, List.of(), List.of(given), List.of(busy("r1", 5, 5, 1), free("r2", 5, x))));
  }
}
