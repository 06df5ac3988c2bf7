package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

class SolidIndexTest {
  private static final double FAR = 3;

  /** Metres along a ray in steps of this the checker looks whether it is inside a solid. */
  private static final double STEP = 0.001;

  private final Random random = new Random(1);
  private final SolidIndex index = new SolidIndex();

  @Test
  void rayMeetsTheFirstSolidOfAllThatWereAddedMovedAndRemoved() {
    List<Solid> solids = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      Solid solid = new Solid(place(), 0.05 + random.nextDouble(1.2));
      index.add(solid);
      solids.add(solid);
    }
    for (int turn = 0; turn < 100; turn++) {
      index.move(solids.get(random.nextInt(solids.size())), place());
      Solid self = solids.get(random.nextInt(solids.size()));
      Pose ray = place();
      assertEquals(
          firstInside(ray, solids.stream().filter(solid -> solid != self).toList()),
          index.distance(ray, FAR, self),
          2 * STEP,
          () -> "from " + ray);
      if (turn % 4 == 0) {
        index.remove(solids.removeFirst());
      }
    }
  }

  /** It walks along the ray; what it steps over is too small to be met for long. */
  private static double firstInside(Pose ray, List<Solid> solids) {
    Vec2 step = new Vec2(Math.cos(ray.theta()), Math.sin(ray.theta()));
    for (double along = 0; along < FAR; along += STEP) {
      Vec2 point = ray.position().plus(step.times(along));
      if (solids.stream().anyMatch(s -> s.at().position().distanceTo(point) < s.radius())) {
        return along;
      }
    }
    return FAR;
  }

  private Pose place() {
    return new Pose(
        random.nextDouble(-10, 10), random.nextDouble(-10, 10), random.nextDouble(2 * Math.PI));
  }

  @Test
  void rayAsksThoseThatAreNearHoweverManyThereAre() {
    List<Solid> row =
        IntStream.range(0, 500).mapToObj(i -> new Solid(new Pose(i, 0.5, 0), 0.13)).toList();
    row.forEach(index::add);

    row.forEach(solid -> index.distance(solid.at(), 0.8, solid));

    // 0.8 m to the east and the radius on both sides: at most the squares before and after its own
    assertTrue(index.asked() <= 2L * row.size(), () -> "asked " + index.asked());
  }
}
