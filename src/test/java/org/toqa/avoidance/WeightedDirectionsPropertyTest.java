package org.toqa.avoidance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.geometry.Vec2;

class WeightedDirectionsPropertyTest {
  private static final double ROUNDING = 1e-12;

  @Example
  void oneThingSeenIsWeighedAgainstTheGoal() {
    // 0.25 m away, weight 0.75, on the left: ((1, 0) + 0.75 (0, -1)) / 2
    Vec2 direction = WeightedDirections.direction(new Vec2(3, 0), List.of(new Vec2(0, 0.25)));

    assertEquals(0.5, direction.x(), ROUNDING);
    assertEquals(-0.375, direction.y(), ROUNDING);
  }

  @Property
  void whoSeesNothingGoesStraightToTheGoal(@ForAll("points") Vec2 next) {
    Vec2 direction = WeightedDirections.direction(next, List.of());

    assertEquals(1, direction.norm(), ROUNDING);
    assertEquals(next.angle(), direction.angle(), ROUNDING);
  }

  @Property
  void whatIsOutOfReachTurnsNobody(@ForAll("points") Vec2 next, @ForAll("points") Vec2 thing) {
    Vec2 far = thing.times(WeightedDirections.REACH / thing.norm() + ROUNDING);

    Vec2 direction = WeightedDirections.direction(next, List.of(far));

    assertEquals(next.angle(), direction.angle(), 1e-9);
  }

  @Property
  void noThingPullsAndTheSumIsBounded(
      @ForAll("points") Vec2 next,
      @ForAll("points") Vec2 thing,
      @ForAll("things") List<Vec2> others) {
    Vec2 without = WeightedDirections.direction(next, others).times(others.size() + 1);
    List<Vec2> all = new ArrayList<>(others);
    all.add(thing);
    Vec2 with = WeightedDirections.direction(next, all);

    assertTrue(with.norm() <= 1 + ROUNDING);
    assertTrue(dot(with.times(all.size() + 1), thing) <= dot(without, thing) + ROUNDING);
  }

  @Property
  void leftAndRightAreAlike(@ForAll("points") Vec2 next, @ForAll("things") List<Vec2> things) {
    Vec2 direction = WeightedDirections.direction(next, things);
    Vec2 mirrored =
        WeightedDirections.direction(
            mirror(next), things.stream().map(WeightedDirectionsPropertyTest::mirror).toList());

    assertEquals(0, mirror(direction).distanceTo(mirrored), ROUNDING);
  }

  @Provide
  Arbitrary<Vec2> points() {
    return Combinators.combine(coordinates(), coordinates())
        .as(Vec2::new)
        .filter(point -> point.norm() > 0.01);
  }

  @Provide
  Arbitrary<List<Vec2>> things() {
    return points().list().ofMaxSize(5);
  }

  private static Arbitrary<Double> coordinates() {
    return Arbitraries.doubles().between(-2, 2);
  }

  private static Vec2 mirror(Vec2 v) {
    return new Vec2(v.x(), -v.y());
  }

  private static double dot(Vec2 a, Vec2 b) {
    return a.x() * b.x() + a.y() * b.y();
  }
}
