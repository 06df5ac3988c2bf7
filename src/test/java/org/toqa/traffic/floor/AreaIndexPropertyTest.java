package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.toqa.geometry.Vec2;

/** What is found by place is what is found by looking at all. */
class AreaIndexPropertyTest {
  private static final double SIDE = 6;

  @Property(tries = 50, seed = "20261126")
  void itAnswersAsIfAllAreasWereLookedAt(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    List<SweptArea> areas = Stream.generate(() -> area(random)).limit(random.nextInt(12)).toList();
    AreaIndex index = new AreaIndex(areas);
    for (int i = 0; i < 20; i++) {
      SweptArea asked = area(random);
      SweptArea standing = area(random);
      assertEquals(
          areas.stream().allMatch(area -> Clearance.isKept(asked, area)), index.isKept(asked));
      assertEquals(
          areas.stream().allMatch(area -> Clearance.isKept(standing, asked, area)),
          index.isKept(standing, asked));
    }
  }

  @Property(tries = 50, seed = "20261126")
  void aPointIsNearIfOneOfAllIs(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    double reach = 0.3 + 3 * random.nextDouble();
    PointIndex index = new PointIndex(reach);
    List<Vec2> points = Stream.generate(() -> point(random)).limit(random.nextInt(6)).toList();
    points.forEach(index::add);
    for (int i = 0; i < 20; i++) {
      Vec2 asked = point(random);
      assertEquals(
          points.stream().anyMatch(point -> point.distanceTo(asked) < reach), index.hasNear(asked));
    }
  }

  /** A disc that is moved by up to 2 m, or stands. */
  private static SweptArea area(Random random) {
    Vec2 from = point(random);
    Vec2 by = new Vec2(random.nextDouble(-2, 2), random.nextDouble(-2, 2));
    Vec2 to = random.nextBoolean() ? from : from.plus(by);
    return SweptArea.along(from, to, 0.05 + 0.4 * random.nextDouble());
  }

  private static Vec2 point(Random random) {
    return new Vec2(random.nextDouble(-SIDE, SIDE), random.nextDouble(-SIDE, SIDE));
  }
}
