package org.toqa.lab.cmct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import net.jqwik.api.lifecycle.AfterContainer;
import org.toqa.lab.experiment.Run;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.cmct.CmctPlanner;
import org.toqa.testbed.Cases;

@Tag("full")
class CarryingWorldPropertyTest {
  private static final int BOXES = 4;

  /** Seconds; what is not done then is not done ever. */
  private static final double LONGEST = 40_000;

  private static final Cases KILLS = new Cases("robots that failed while boxes were carried");

  @AfterContainer
  static void someFailed() {
    KILLS.assertPossible(0.0005);
  }

  @Property(tries = 4, shrinking = ShrinkingMode.OFF)
  void everyBoxComesToItsTargetOnce(@ForAll long seed) {
    assertCarries(seed, true, true, 0);
  }

  @Property(tries = 3, shrinking = ShrinkingMode.OFF)
  void everyBoxComesToItsTargetOnceWithoutOverlap(@ForAll long seed) {
    assertCarries(seed, true, false, 0);
  }

  @Property(tries = 3, shrinking = ShrinkingMode.OFF)
  void everyBoxComesToItsTargetOnceWithoutSupervisor(@ForAll long seed) {
    assertCarries(seed, false, true, 0);
  }

  /** Supervisor and workers fail at any moment, and start again within two minutes. */
  @Property(tries = 8, shrinking = ShrinkingMode.OFF)
  void nothingIsLostWhenRobotsFail(@ForAll long seed) {
    assertCarries(seed, true, true, 800);
  }

  private static void assertCarries(
      long seed, boolean isSupervised, boolean overlaps, int stepsToFailure) {
    SplittableRandom random = new SplittableRandom(seed);
    CarryingScene scene = CarryingScene.of(0.15, BOXES, 0.3, 5, random);
    CarryingWorld world =
        new CarryingWorld(
            scene,
            CarryingSetup.of(
                Run.of(1, 1),
                isSupervised,
                overlaps,
                random.nextBoolean() ? new CmctPlanner() : new JumpPointSearch()));
    Map<String, Double> failed = new TreeMap<>();
    while (!world.isDone() && world.time() < LONGEST) {
      world.step();
      if (stepsToFailure > 0 && KILLS.count(random.nextInt(stepsToFailure) == 0)) {
        String robot = "R" + (1 + random.nextInt(3));
        world.kill(robot);
        failed.put(robot, world.time() + random.nextInt(120));
      }
      for (String robot : Map.copyOf(failed).keySet()) {
        if (failed.getOrDefault(robot, 0.0) < world.time()) {
          failed.remove(robot);
          world.revive(robot);
        }
      }
      assertEquals(BOXES, world.boxes(), world::toString);
    }
    assertTrue(world.isDone(), world::toString);
    assertTrue(world.isEachAtTarget(), world::toString);
    assertTrue(world.deliveries().values().stream().allMatch(times -> times == 1));
    assertTrue(world.nearest() > 0, () -> "touched: " + world.nearest());
  }
}
