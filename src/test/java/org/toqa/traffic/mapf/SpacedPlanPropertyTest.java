package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.testbed.Cases;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/** Plans on cells that robots side by side would not have room on, looked at by the rules alone. */
class SpacedPlanPropertyTest {
  private static final int WIDTH = 14;
  private static final int HEIGHT = 10;
  private final Cases plans = new Cases("plans");

  @Property(tries = 150, seed = "20261123")
  void nobodyComesTooNearAndSomebodyCanAlwaysGoFirst(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    RoadGraph roads = hall(random);
    double distance = random.nextBoolean() ? 1.2 : 1.5;
    int robots = 2 + random.nextInt(7);
    int[] starts = apart(roads, robots, distance, random);
    int[] goals = apart(roads, robots, distance, random);
    AtomicLong looks = new AtomicLong();
    Optional<List<int[]>> plan =
        new LacamJointPlanner()
            .plan(
                roads,
                new Spacing(roads, distance),
                starts,
                goals,
                Deadline.in(Duration.ofSeconds(1), () -> 1000 * looks.incrementAndGet()));
    plans.count(plan.isPresent());
    plan.ifPresent(steps -> assertKept(roads, distance, starts, goals, steps));
  }

  @AfterProperty
  void plansWereFound() {
    plans.assertPossible(0.9);
  }

  private static void assertKept(
      RoadGraph roads, double distance, int[] starts, int[] goals, List<int[]> steps) {
    assertArrayEquals(starts, steps.getFirst());
    assertArrayEquals(goals, steps.getLast());
    for (int step = 0; step < steps.size(); step++) {
      int[] at = steps.get(step);
      for (int i = 0; i < at.length; i++) {
        for (int k = 0; k < i; k++) {
          assertTrue(apart(roads, at[i], at[k]) >= distance, "too near in step " + step);
        }
      }
      if (step > 0) {
        assertCanBeDriven(roads, distance, steps.get(step - 1), at);
      }
    }
  }

  /** One after the other: each moves once nobody is too near to where it goes. */
  private static void assertCanBeDriven(RoadGraph roads, double distance, int[] from, int[] to) {
    int[] at = from.clone();
    Set<Integer> left = new HashSet<>();
    for (int i = 0; i < at.length; i++) {
      int there = to[i];
      boolean isBeside = false;
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        isBeside |= roads.neighbour(from[i], d) == there;
      }
      assertTrue(isBeside || there == from[i], "a robot jumps");
      if (there != from[i]) {
        left.add(i);
      }
    }
    boolean isAnyMoved = true;
    while (isAnyMoved) {
      isAnyMoved = false;
      for (int i : List.copyOf(left)) {
        boolean isClear = true;
        for (int k = 0; k < at.length; k++) {
          isClear &= k == i || apart(roads, to[i], at[k]) >= distance;
        }
        if (isClear) {
          at[i] = to[i];
          left.remove(i);
          isAnyMoved = true;
        }
      }
    }
    assertFalse(!left.isEmpty(), "robots " + left + " wait for each other");
  }

  private static double apart(RoadGraph roads, int one, int other) {
    return Math.hypot(
        roads.columnOf(one) - roads.columnOf(other), roads.rowOf(one) - roads.rowOf(other));
  }

  private static RoadGraph hall(Random random) {
    BitSet occupied = new BitSet();
    for (int pillars = random.nextInt(6); pillars > 0; pillars--) {
      occupied.set(random.nextInt(WIDTH * HEIGHT));
    }
    return new RoadGraph(new OccupancyGrid(WIDTH, HEIGHT, 1, Vec2.ZERO, occupied));
  }

  /** Vertices of the largest part that are far enough apart. */
  private static int[] apart(RoadGraph roads, int count, double distance, Random random) {
    List<Integer> all = new ArrayList<>();
    for (int v = 0; v < roads.vertexCount(); v++) {
      if (roads.isInLargestPart(v)) {
        all.add(v);
      }
    }
    Collections.shuffle(all, random);
    List<Integer> found = new ArrayList<>();
    for (int v : all) {
      if (found.size() < count && found.stream().allMatch(o -> apart(roads, v, o) >= distance)) {
        found.add(v);
      }
    }
    return found.stream().mapToInt(v -> v).toArray();
  }
}
