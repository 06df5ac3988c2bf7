package org.toqa.traffic.mapf;

import java.util.Optional;
import java.util.SplittableRandom;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.testbed.Cases;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.MapfResult.Solved;

/** Guided plans on crowded floors, looked at by the rules alone. */
class GuidedPlanningPropertyTest {
  private final Cases plans = new Cases("plans");

  @Provide
  Arbitrary<Floor> crowded() {
    return RandomFloors.strewn(8, 0.2, 24);
  }

  @Property(tries = 200)
  void leadsAllToTheirGoalsByTheRules(@ForAll("crowded") Floor floor) {
    RoadGraph roads = new RoadGraph(floor.grid());
    int[] starts = floor.starts().stream().mapToInt(roads::vertex).toArray();
    int[] goals = floor.goals().stream().mapToInt(roads::vertex).toArray();
    for (int robot = 0; robot < starts.length; robot++) {
      if (!roads.canReach(starts[robot], goals[robot])) {
        return;
      }
    }
    char[][] distances = DistanceTables.of(roads, goals, Deadline.none());

    Optional<int[][]> plan =
        new GuidedPlanning(roads, distances, starts, goals, new SplittableRandom(3))
            .plan(new CountedDeadline(20_000).deadline());

    if (canBePlanned(roads, distances, starts, goals)) {
      plans.count(plan.isPresent());
    }
    plan.ifPresent(
        paths ->
            PlanAssertions.assertSound(
                new MapfInstance(roads, floor.starts(), floor.goals()),
                new Solved(new MapfPlan(roads, paths), lowerBound(distances, starts))));
  }

  @AfterProperty
  void plansWereFound() {
    plans.assertPossible(0.9);
  }

  private static boolean canBePlanned(
      RoadGraph roads, char[][] distances, int[] starts, int[] goals) {
    StepSearch steps = new Pibt(roads, distances, goals, new SplittableRandom(4), true);
    return new Lacam(roads, distances, starts, goals, new SplittableRandom(5), steps)
            .search(new CountedDeadline(2000).deadline())
        instanceof Lacam.Outcome.Found;
  }

  private static long lowerBound(char[][] distances, int[] starts) {
    long sum = 0;
    for (int robot = 0; robot < starts.length; robot++) {
      sum += distances[robot][starts[robot]];
    }
    return sum;
  }
}
