package org.toqa.lab.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.formation.swarm.SwarmLaw;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.lab.experiment.Run;

class SwarmDriveTest {
  private static final SwarmSetup SETUP = SwarmSetup.of(Run.of(1, 1));

  private static SwarmMap empty() {
    return new SwarmMap(
        "empty", new OccupancyGrid(100, 60, SwarmMap.CELL, Vec2.ZERO, new java.util.BitSet()));
  }

  private static SwarmDrive.Result drive(SwarmMap map, SwarmSetup setup, double speed, long seed) {
    SwarmLaw law = new SwarmLaw(Math.toRadians(5), 0.001, 0.01);
    return new SwarmDrive(map, setup, law, speed, new SplittableRandom(seed)).run();
  }

  /** 1660 m less the target's radius of 60 m at 2 m a step = 800 steps. */
  @Test
  void inTheOpenTheSwarmDrivesStraightToItsTargetAndKeepsItsShape() {
    SwarmLaw straight = new SwarmLaw(Math.toRadians(5), 0, 0);
    SwarmDrive.Result result =
        new SwarmDrive(empty(), SETUP, straight, 2, new SplittableRandom(1)).run();

    assertTrue(result.isReached());
    assertEquals(800, result.steps());
    assertEquals(0, result.lost());
    assertEquals(0, result.shapeError(), 1e-9);
  }

  @Test
  void noiseOfTheWheelsStaysInTheShapeOfThePublishedLawOnly() {
    SwarmSetup noisy = SETUP.under(0, 0, 0.2, false);
    double published = drive(empty(), noisy, 2, 1).shapeError();
    double extended = drive(empty(), noisy.keepingShape(), 2, 1).shapeError();

    // a random walk: 0.2 x 2 m x sqrt(2 x 800 steps) = 16 m
    assertTrue(published > 8 && published < 32, () -> "published " + published);
    assertTrue(extended < 2, () -> "extended " + extended);
  }

  /**
   * A wall beside the way, 100 m from the outermost robots: the rays that look most outward, by 50
   * degrees, meet it after 131 m, and see 120 m.
   */
  @Test
  void noiseShowsWhatIsFartherThanTheRange() {
    Vec2 beside = SwarmMap.START.plus(new Vec2(200, 140));
    SwarmMap map = empty().with(beside, beside.plus(new Vec2(1000, 20)));

    assertEquals(0, aside(map, SETUP), 1e-9);
    assertTrue(aside(map, SETUP.under(0, 0.1, 0, false)) > 10);
  }

  /** How far the leader's way leads from the straight line, metres. */
  private static double aside(SwarmMap map, SwarmSetup setup) {
    SwarmLaw law = new SwarmLaw(Math.toRadians(5), 0, 0);
    return new SwarmDrive(map, setup, law, 2, new SplittableRandom(1))
        .run().track().stream()
            .mapToDouble(place -> Math.abs(place.y() - SwarmMap.START.y()))
            .max()
            .orElseThrow();
  }

  @ParameterizedTest
  @ValueSource(strings = {"simple", "complex"})
  void aMapHasAStartATargetAndAWayForTheRigidSwarm(String name) {
    SwarmMap map = SwarmMap.named(name);
    double shortest = map.shortest(SETUP.places(), SETUP.robotRadius());

    assertTrue(shortest > SwarmMap.START.distanceTo(SwarmMap.TARGET));
    assertTrue(shortest < 1.5 * SwarmMap.START.distanceTo(SwarmMap.TARGET));
    for (Vec2 place : SETUP.places()) {
      assertFalse(map.touches(SwarmMap.START.plus(place), SETUP.robotRadius()));
      assertFalse(map.touches(SwarmMap.TARGET.plus(place), SETUP.robotRadius()));
    }
  }

  /** One wall square from (200, 200) to (220, 220). */
  @Test
  void aRobotTouchesASquareWhereItsDiscReachesIntoIt() {
    SwarmMap map = empty().with(new Vec2(200, 200), new Vec2(220, 220));

    assertTrue(map.touches(new Vec2(195, 210), 6));
    assertFalse(map.touches(new Vec2(193, 210), 6));
    assertFalse(map.touches(new Vec2(195, 195), 6), "7.07 m from the corner");
    assertTrue(map.touches(new Vec2(196, 196), 6), "5.66 m from the corner");
    assertTrue(map.touches(new Vec2(5, 600), 6), "the border is wall");
  }

  @Test
  void theSameSeedDrivesTheSameWay() {
    SwarmMap map = SwarmMap.named("simple");

    assertEquals(drive(map, SETUP, 3, 5), drive(map, SETUP, 3, 5));
    assertFalse(drive(map, SETUP, 3, 5).equals(drive(map, SETUP, 3, 6)));
  }

  @Test
  void aSwarmThatSeesNothingIsLostAtTheFirstObstacle() {
    SwarmMap map = SwarmMap.named("simple");
    SwarmSetup blind = new SwarmSetup(6, 0, 0, 0, 40, 60, 0, 0, 0, false, SETUP.keeping(), false);
    SwarmDrive.Result result = drive(map, blind, 2, 1);

    assertFalse(result.isReached());
    assertEquals(9, result.lost());
    assertEquals(List.of(), result.shapeErrors().stream().filter(e -> e > 1e-6).toList());
  }
}
