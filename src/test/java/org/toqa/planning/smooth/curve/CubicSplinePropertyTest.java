package org.toqa.planning.smooth.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.smooth.DiscSpace;

class CubicSplinePropertyTest {
  @Provide
  Arbitrary<List<Vec2>> points() {
    Arbitrary<Double> coordinates = Arbitraries.doubles().between(-10, 10);
    return Combinators.combine(coordinates, coordinates)
        .as(Vec2::new)
        .list()
        .ofMinSize(2)
        .ofMaxSize(12);
  }

  @Property
  void positionAndBothDerivativesAreContinuous(@ForAll("points") List<Vec2> points) {
    CubicSpline spline = CubicSpline.through(points);
    double step = 1e-9;
    for (int knot = 1; knot < spline.spans(); knot++) {
      assertSame(spline.position(knot - step), spline.position(knot));
      assertSame(spline.velocity(knot - step), spline.velocity(knot));
      assertSame(spline.acceleration(knot - step), spline.acceleration(knot));
    }
    assertSame(points.getFirst(), spline.position(0));
    assertSame(points.getLast(), spline.position(spline.end()));
    assertEquals(0, spline.acceleration(0).norm(), 1e-9);
  }

  @Property
  void derivativesAreThoseOfThePosition(@ForAll("points") List<Vec2> points) {
    CubicSpline spline = CubicSpline.through(points);
    double h = 1e-5;
    for (double u = 0.3; u < spline.end(); u += 0.7) {
      Vec2 slope = spline.position(u + h).minus(spline.position(u - h)).times(1 / (2 * h));
      assertEquals(0, slope.distanceTo(spline.velocity(u)), 1e-4);
    }
  }

  private static void assertSame(Vec2 expected, Vec2 found) {
    assertEquals(0, expected.distanceTo(found), 1e-6);
  }

  @Test
  void headingsAtTheEndsAreKeptWhereThereIsRoom() {
    DiscSpace space = DiscSpace.of(OccupancyGrid.parse("......", "......", "......"), 0.2);
    List<Vec2> path = List.of(new Vec2(1, 1.5), new Vec2(5, 1.5));
    SmoothCurve curve = new SplineFitter(space).fit(path, 0.5, -0.4);
    CubicSpline spline = curve.pieces().getFirst();
    assertEquals(0.5, spline.velocity(0).angle(), 1e-9);
    assertEquals(-0.4, spline.velocity(spline.end()).angle(), 1e-9);
    assertSame(path.getFirst(), spline.position(0));
    assertSame(path.getLast(), spline.position(spline.end()));
    assertEquals(1, curve.pieces().size());
    assertTrue(curve.maxCurvature() > 0);
  }

  @Test
  void aSplineHasFourControlPoints() {
    assertThrows(
        IllegalArgumentException.class, () -> new CubicSpline(List.of(Vec2.ZERO, Vec2.ZERO)));
  }
}
