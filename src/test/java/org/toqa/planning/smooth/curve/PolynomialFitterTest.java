package org.toqa.planning.smooth.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.DiscSpace;

class PolynomialFitterTest {
  private static final OccupancyGrid EMPTY =
      OccupancyGrid.parse("..........", "..........", "..........", "..........");

  private static PolynomialFitter fitter(OccupancyGrid grid) {
    return new PolynomialFitter(DiscSpace.of(grid, 0.3));
  }

  @Test
  void aParabolaIsFoundAgain() {
    // y = 1 + x (8 - x) / 16 from x = 1 to x = 9, seen from its start
    List<Vec2> path =
        IntStream.rangeClosed(0, 800)
            .mapToObj(i -> i / 100.0)
            .map(x -> new Vec2(1 + x, 1 + x * (8 - x) / 16))
            .toList();
    PolynomialCurve curve = fitter(EMPTY).fit(path).orElseThrow();
    assertEquals(2, curve.degree());
    assertEquals(1 + 4 * 4 / 16.0, curve.position(0.5).y(), 1e-4);
    // y'' = -1/8 by x, and 64 times that by t
    assertEquals(-8, curve.acceleration(0.3).y(), 1e-2);
  }

  @Test
  void itGoesWestToo() {
    List<Vec2> path = List.of(new Vec2(9, 1), new Vec2(5, 3), new Vec2(1, 1));
    PolynomialCurve curve = fitter(EMPTY).fit(path).orElseThrow();
    assertEquals(path.getFirst(), curve.position(0));
    assertEquals(0, curve.position(1).distanceTo(path.getLast()), 1e-12);
    assertTrue(curve.position(0.5).y() > 2);
  }

  @Test
  void whatIsNoFunctionOfXIsRefused() {
    List<Vec2> path = List.of(new Vec2(1, 1), new Vec2(5, 1), new Vec2(4, 3));
    assertTrue(fitter(EMPTY).fit(path).isEmpty());
  }

  @Test
  void whatWouldTouchIsRefused() {
    OccupancyGrid wall =
        OccupancyGrid.parse("..........", ".@@@@@@@@.", "..........", "..........");
    // close below the wall: each polynomial overshoots somewhere
    List<Vec2> path =
        List.of(new Vec2(0.35, 3.6), new Vec2(0.5, 1.69), new Vec2(9.5, 1.69), new Vec2(9.65, 3.6));
    assertTrue(DiscSpace.of(wall, 0.3).isFree(path.get(1), path.get(2)));
    assertTrue(fitter(wall).fit(path).isEmpty());
  }
}
