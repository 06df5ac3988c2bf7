package org.toqa.planning.smooth.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.DiscSpace;

class SplineFitterTest {
  private static final List<Vec2> BEND =
      List.of(new Vec2(10, 10), new Vec2(90, 10), new Vec2(90, 90));

  private final DiscSpace space =
      DiscSpace.of(new OccupancyGrid(100, 100, 1, Vec2.ZERO, new BitSet()), 0.1);

  @Test
  void longLinesHaveFewControlPoints() {
    SmoothCurve curve = new SplineFitter(space).fit(BEND);
    assertEquals(1, curve.pieces().size());
    // 160 m / (2 x 0.1 m) = 800, and some more at the bend and the ends
    assertTrue(curve.pieces().getFirst().controls().size() < 850);
  }

  @Test
  void theCurveLeavesLongLinesOnlyBesideTheirBend() {
    for (Vec2 point : new SplineFitter(space).fit(BEND).points(0.05)) {
      double offLines = Math.min(Math.abs(point.y() - 10), Math.abs(point.x() - 90));
      assertTrue(offLines < (point.distanceTo(BEND.get(1)) < 0.1 ? 0.05 : 1e-9));
    }
  }
}
