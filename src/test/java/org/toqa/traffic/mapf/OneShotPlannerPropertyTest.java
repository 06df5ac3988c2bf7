package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicLong;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.MapfResult.Reason;
import org.toqa.traffic.mapf.MapfResult.Solved;
import org.toqa.traffic.mapf.MapfResult.Unsolved;

@Tag("full")
class OneShotPlannerPropertyTest {

  @Provide
  Arbitrary<Floor> tiny() {
    return RandomFloors.strewn(3, 0.4, 3);
  }

  @Provide
  Arbitrary<Floor> small() {
    return RandomFloors.strewn(8, 0.3, 12);
  }

  @Property(tries = 125)
  void plansExactlyWhatCanBePlanned(@ForAll("tiny") Floor floor) {
    MapfInstance instance =
        new MapfInstance(new RoadGraph(floor.grid()), floor.starts(), floor.goals());
    OptionalInt shortest =
        new JointSearch(floor.grid()).shortestMakespan(floor.starts(), floor.goals());

    MapfResult result = solve(instance, 3);

    if (shortest.isPresent()) {
      Solved solved = assertInstanceOf(Solved.class, result);
      PlanAssertions.assertSound(instance, solved);
      assertTrue(solved.plan().makespan() >= shortest.getAsInt());
    } else {
      Unsolved unsolved = assertInstanceOf(Unsolved.class, result);
      boolean isApart = unsolved.reason() == Reason.NO_WAY;
      assertTrue(isApart || unsolved.reason() == Reason.NO_PLAN, unsolved::toString);
    }
  }

  @Property(tries = 75)
  void everyPlanIsSoundAndNeverWorseThanTheFirst(@ForAll("small") Floor floor) {
    MapfInstance instance =
        new MapfInstance(new RoadGraph(floor.grid()), floor.starts(), floor.goals());
    AtomicLong first = new AtomicLong();

    MapfResult result =
        new OneShotPlanner(7).solve(instance, ticks(2000), plan -> first.set(plan.sumOfCosts()));

    if (result instanceof Solved solved) {
      PlanAssertions.assertSound(instance, solved);
      assertTrue(solved.plan().sumOfCosts() <= first.get());
    }
  }

  @Property(tries = 25)
  void theSameSeedGivesTheSamePlan(@ForAll("small") Floor floor) {
    MapfInstance instance =
        new MapfInstance(new RoadGraph(floor.grid()), floor.starts(), floor.goals());

    assertEquals(cost(solve(instance, 5)), cost(solve(instance, 5)));
  }

  private static long cost(MapfResult result) {
    return result instanceof Solved solved ? solved.plan().sumOfCosts() : -1;
  }

  private static MapfResult solve(MapfInstance instance, long seed) {
    return new OneShotPlanner(seed).solve(instance, ticks(20_000), plan -> {});
  }

  /** A deadline that comes after it has been asked so often: time that only work passes. */
  private static Deadline ticks(long count) {
    AtomicLong asked = new AtomicLong();
    return new Deadline(asked::getAndIncrement, count);
  }
}
