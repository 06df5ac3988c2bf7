package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class SimplifiedPathPropertyTest {
  private static final double REACH = 0.006; // half a centimetre, and what is rounded

  @Property
  void everyPointLiesByTheDrawnRouteInItsOrder(
      @ForAll @Size(max = 30) List<@DoubleRange(min = -3, max = 3) Double> turns,
      @ForAll @DoubleRange(min = 0.01, max = 0.4) double step,
      @ForAll @IntRange(min = 0, max = 31) int wanted) {
    List<Vec2> route = route(turns, step);
    int released = Math.min(wanted, route.size());

    SimplifiedPath drawn = SimplifiedPath.of(route, released);

    int leg = 0;
    for (Vec2 point : route) {
      while (distance(drawn.points(), leg, point) > REACH) {
        leg++;
        assertTrue(leg < drawn.points().size(), "nowhere near " + point);
      }
    }
    assertNear(route.getFirst(), drawn.points().getFirst());
    assertNear(route.getLast(), drawn.points().getLast());
    assertEquals(released == 0, drawn.released() == 0);
    if (released > 0) {
      assertNear(route.get(released - 1), drawn.points().get(drawn.released() - 1));
    }
  }

  @Test
  void straightPartsHaveTwoPoints() {
    List<Vec2> route =
        List.of(
            new Vec2(0, 0),
            new Vec2(0.3, 0),
            new Vec2(0.6, 0),
            new Vec2(0.9, 0),
            new Vec2(0.9, 0.30000001),
            new Vec2(0.9, 0.6));

    SimplifiedPath drawn = SimplifiedPath.of(route, 2);

    assertEquals(
        List.of(new Vec2(0, 0), new Vec2(0.3, 0), new Vec2(0.9, 0), new Vec2(0.9, 0.6)),
        drawn.points());
    assertEquals(2, drawn.released());
    assertEquals(new SimplifiedPath(List.of(), 0), SimplifiedPath.of(List.of(), 0));
  }

  private static List<Vec2> route(List<Double> turns, double step) {
    List<Vec2> route = new ArrayList<>(List.of(new Vec2(1, 1)));
    double heading = 0;
    for (double turn : turns) {
      heading += turn;
      Vec2 last = route.getLast();
      route.add(new Vec2(last.x() + step * Math.cos(heading), last.y() + step * Math.sin(heading)));
    }
    return route;
  }

  /** From a point to a leg; the last one is a point. */
  private static double distance(List<Vec2> points, int leg, Vec2 point) {
    return point.distanceToLine(points.get(leg), points.get(Math.min(leg + 1, points.size() - 1)));
  }

  private static void assertNear(Vec2 expected, Vec2 actual) {
    assertEquals(expected.x(), actual.x(), 0.0006);
    assertEquals(expected.y(), actual.y(), 0.0006);
  }
}
