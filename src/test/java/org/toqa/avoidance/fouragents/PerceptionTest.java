package org.toqa.avoidance.fouragents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * A robot of 0.1 m radius at the origin, whose front left sensor reads something; its own rays meet
 * a known square, with edges of 0.4 m, 0.2 m before the rim, or little more.
 */
class PerceptionTest {
  private static final double FARTHEST = 0.5;
  private static final int FRONT = 2;
  private static final Perception PERCEPTION = new Perception(new RangeRing(0.1, FARTHEST), 0.01);
  private static final List<Vec2> SQUARE =
      List.of(new Vec2(0.3, -0.2), new Vec2(0.7, -0.2), new Vec2(0.7, 0.2), new Vec2(0.3, 0.2));
  private static final StaticObstacle OUTLINE = StaticObstacle.around(SQUARE);
  private static final StaticObstacle CIRCLE =
      new StaticObstacle(OUTLINE.centre(), OUTLINE.radius());

  /** What is unknown of a reading. */
  private static double unknown(double reading, StaticObstacle... known) {
    List<Double> ranges = new ArrayList<>(Collections.nCopies(RangeRing.SIZE, FARTHEST));
    ranges.set(FRONT, reading);
    return PERCEPTION.percept(ranges, new Pose(0, 0, 0), List.of(known)).unknown().get(FRONT);
  }

  @Test
  void aKnownObstacleIsKnown() {
    assertEquals(FARTHEST, unknown(0.205, OUTLINE));
    assertEquals(FARTHEST, unknown(0.195, OUTLINE), "by noise");
    assertEquals(0.205, unknown(0.205));
  }

  /** 0.15 m before the rim, and in the circle of 0.283 m round the square. */
  @Test
  void whatStandsBeforeAKnownObstacleIsNotKnown() {
    assertEquals(0.15, unknown(0.15, OUTLINE));
    assertEquals(0, unknown(0, OUTLINE));
  }

  /** Of a circle nobody knows what of it is filled. */
  @Test
  void allInACircleIsKnownWhereOnlyThatIs() {
    assertEquals(FARTHEST, unknown(0.15, CIRCLE));
    assertEquals(0.1, unknown(0.1, CIRCLE));
  }

  @Test
  void whereNothingIsToBeSeenAShortReadingIsNotKnown() {
    StaticObstacle behind =
        StaticObstacle.around(SQUARE.stream().map(corner -> corner.times(-1)).toList());

    assertEquals(0.495, unknown(0.495, behind));
  }
}
