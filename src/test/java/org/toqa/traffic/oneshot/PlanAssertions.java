package org.toqa.traffic.oneshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.toqa.planning.Heading;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.Stance;
import org.toqa.traffic.TrafficChecker;
import org.toqa.traffic.oneshot.MapfResult.Solved;

/** What every plan has to be. */
final class PlanAssertions {
  private PlanAssertions() {}

  /** It leads from the starts to the goals by the rules, and costs what it says. */
  static void assertSound(MapfInstance instance, Solved solved) {
    MapfPlan plan = solved.plan();
    TrafficChecker checker = new TrafficChecker(instance.roads().grid(), MotionModel.CLASSIC);
    List<Stance> stances = stances(plan, 0);
    assertEquals(instance.starts(), stances.stream().map(Stance::cell).toList());
    assertEquals(List.of(), checker.checkPlaces(stances));
    for (int step = 1; step <= plan.makespan(); step++) {
      List<Stance> next = stances(plan, step);
      assertEquals(List.of(), checker.check(stances, next));
      stances = next;
    }
    assertEquals(instance.goals(), stances.stream().map(Stance::cell).toList());
    assertEquals(
        IntStream.range(0, plan.robots()).mapToLong(r -> lastMove(plan, r)).sum(),
        plan.sumOfCosts());
    assertTrue(plan.sumOfCosts() >= solved.lowerBound());
  }

  private static int lastMove(MapfPlan plan, int robot) {
    int step = plan.makespan();
    while (step > 0 && plan.at(robot, step - 1).equals(plan.at(robot, step))) {
      step--;
    }
    return step;
  }

  private static List<Stance> stances(MapfPlan plan, int step) {
    return IntStream.range(0, plan.robots())
        .mapToObj(robot -> new Stance(plan.at(robot, step), Heading.EAST))
        .toList();
  }
}
