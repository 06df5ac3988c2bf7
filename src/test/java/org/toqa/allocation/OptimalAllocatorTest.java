package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.allocation.Floors.NOON;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.util.List;
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
      if (problem.waiting().stream().anyMatch(t -> TeamAllocator.isForSeveral(problem, t))) {
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
