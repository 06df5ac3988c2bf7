package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.check.TrafficChecker;
import org.toqa.traffic.mapf.MapfResult.Solved;

/** What every plan has to be. */
final class PlanAssertions {
  private PlanAssertions() {}

  /** It leads from the starts to the goals by the rules, and costs what it says. */
  static void assertSound(MapfInstance instance, Solved solved) {
    MapfPlan plan = solved.plan();
    TrafficChecker checker = new TrafficChecker(instance.roads().grid(), MotionModel.CLASSIC);
    List<GridPose> stances = stances(plan, 0);
    assertEquals(instance.starts(), stances.stream().map(GridPose::cell).toList());
    assertEquals(List.of(), checker.checkPlaces(stances));
    for (int step = 1; step <= plan.makespan(); step++) {
      List<GridPose> next = stances(plan, step);
      assertEquals(List.of(), checker.check(stances, next));
      stances = next;
    }
    assertEquals(instance.goals(), stances.stream().map(GridPose::cell).toList());
    assertEquals(
        IntStream.range(0, plan.robotCount()).mapToLong(r -> lastMove(plan, r)).sum(),
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

  private static List<GridPose> stances(MapfPlan plan, int step) {
    return IntStream.range(0, plan.robotCount())
        .mapToObj(robot -> new GridPose(plan.at(robot, step), Heading.EAST))
        .toList();
  }
}
