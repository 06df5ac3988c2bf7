package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;

class SweptAreaPropertyTest {
  private static final int MOMENTS = 200;

  /** Against discs at many moments of two drives: never farther than those, and hardly nearer. */
  @Property(tries = 300, seed = "20261123")
  void gapIsThatOfTheNearestMoments(@ForAll long seed) {
    Random random = new Random(seed);
    Pose a = pose(random);
    Pose b = pose(random);
    Segment driveA = segment(random);
    Segment driveB = segment(random);
    double radiusA = 0.1 + random.nextDouble();
    double radiusB = 0.1 + random.nextDouble();
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= MOMENTS; i++) {
      Vec2 middleA = a.advanced(driveA.twist(), driveA.t() * i / MOMENTS).position();
      for (int k = 0; k <= MOMENTS; k++) {
        Vec2 middleB = b.advanced(driveB.twist(), driveB.t() * k / MOMENTS).position();
        nearest = Math.min(nearest, middleA.distanceTo(middleB) - radiusA - radiusB);
      }
    }
    double gap = SweptArea.along(a, driveA, radiusA).gapTo(SweptArea.along(b, driveB, radiusB));
    // two moments are at most 2.4 cm apart on each drive
    assertTrue(gap <= nearest + 1e-9, gap + " is more than " + nearest);
    assertEquals(nearest, gap, 0.03);
  }

  private static Pose pose(Random random) {
    return new Pose(
        4 * random.nextDouble(), 4 * random.nextDouble(), 2 * Math.PI * random.nextDouble());
  }

  private static Segment segment(Random random) {
    if (random.nextInt(4) == 0) {
      return Segment.shift(2 * random.nextDouble() - 1, 0.1 + 4 * random.nextDouble());
    }
    double w = random.nextInt(3) == 0 ? 0 : 2 * random.nextDouble() - 1;
    return new Segment(
        random.nextInt(4) == 0 ? 0 : random.nextDouble(), w, 0.1 + 4 * random.nextDouble());
  }
}
