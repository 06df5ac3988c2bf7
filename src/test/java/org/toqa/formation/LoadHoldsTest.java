package org.toqa.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class LoadHoldsTest {
  @Test
  void whoCarriesTwiceAsMuchHoldsItHalfAsFarFromTheMiddle() {
    Shape two = Shape.around(2, 0.6, 0.4, 0.13);

    // 8 kg * 0.15 m = 4 kg * 0.3 m
    List<Vec2> holds = LoadHolds.of(two, 0.6, 0.4, 0, List.of(8.0, 4.0)).orElseThrow();

    assertEquals(0.15, holds.getFirst().x(), 1e-9);
    assertEquals(-0.3, holds.getLast().x(), 1e-9);
  }

  @Property(tries = 200)
  void theSumOfSharesTimesPointsIsTheMiddleAndEachPointIsOnTheLoad(
      @ForAll @IntRange(min = 2, max = 6) int robots,
      @ForAll @DoubleRange(min = 0.2, max = 2) double length,
      @ForAll @DoubleRange(min = 0.2, max = 2) double width,
      @ForAll @DoubleRange(min = 1, max = 10) double heaviest) {
    List<Double> shares =
        IntStream.range(0, robots).mapToObj(i -> i == 0 ? heaviest : 1.0 + i % 3).toList();
    Shape shape = Shape.around(robots, length, width, 0.13);

    List<Vec2> holds = LoadHolds.of(shape, length, width, 0, shares).orElseThrow();

    Vec2 sum = Vec2.ZERO;
    for (int i = 0; i < robots; i++) {
      Vec2 hold = holds.get(i);
      sum = sum.plus(hold.times(shares.get(i)));
      assertTrue(Math.abs(hold.x()) <= length / 2 + 1e-9, hold::toString);
      assertTrue(Math.abs(hold.y()) <= width / 2 + 1e-9, hold::toString);
    }
    assertEquals(0, sum.norm(), 1e-6);
  }

  @Test
  void twoThatAreNotQuiteOppositeReachToTheSide() {
    Shape two = new Shape(new Vec2(0.5, 0.1), List.of(new Vec2(-0.5, 0.05)));

    List<Vec2> holds = LoadHolds.of(two, 0.6, 0.4, 0, List.of(6.0, 6.0)).orElseThrow();

    assertEquals(0, holds.getFirst().plus(holds.getLast()).norm(), 1e-9);
  }

  @Test
  void robotsOnOneSideCannotHoldIt() {
    Shape beside = new Shape(new Vec2(0.6, 0.2), List.of(new Vec2(0.6, -0.3)));

    assertEquals(Optional.empty(), LoadHolds.of(beside, 0.6, 0.4, 0, List.of(1.0, 1.0)));
  }
}
