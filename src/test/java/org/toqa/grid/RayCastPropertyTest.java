package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.BitSet;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Vec2;

class RayCastPropertyTest {
  private static final double STEP = 1e-4;

  @Example
  void aWallIsAsFarAsItsNearerSide() {
    OccupancyGrid hall = OccupancyGrid.parse("......", "....#.", "......");

    assertEquals(2.5, RayCast.distance(hall, new Vec2(1.5, 1.5), 0, 9), 1e-12);
    assertEquals(1.5, RayCast.distance(hall, new Vec2(1.5, 1.5), Math.PI, 9), 1e-12); // the edge
    assertEquals(2, RayCast.distance(hall, new Vec2(1.5, 1.5), 0, 2), 1e-12);
    assertEquals(0, RayCast.distance(hall, new Vec2(4.5, 1.5), 0, 9), 1e-12); // in the wall
  }

  /** Looked at point by point; corners that are only brushed may be missed by that. */
  @Property(tries = 300)
  void theRayEndsInTheFirstCellThatIsNotFree(
      @ForAll long seed,
      @ForAll @DoubleRange(min = 0, max = 6) double x,
      @ForAll @DoubleRange(min = 0, max = 6) double y,
      @ForAll @DoubleRange(min = -3.2, max = 3.2) double direction) {
    OccupancyGrid grid = strewn(new Random(seed));
    Vec2 origin = new Vec2(x, y).plus(grid.origin());
    double seen = RayCast.distance(grid, origin, direction, 3);

    double marched = 0;
    while (marched < 3 && grid.isFree(at(origin, direction, marched))) {
      marched += STEP;
    }
    boolean isBrushed = seen < marched - 2 * STEP && isInWall(grid, origin, direction, seen);
    assertEquals(isBrushed ? seen : Math.min(3, marched), seen, 2 * STEP);
  }

  private static boolean isInWall(OccupancyGrid grid, Vec2 origin, double direction, double at) {
    return !grid.isFree(at(origin, direction, at + 1e-9));
  }

  private static Vec2 at(Vec2 origin, double direction, double metres) {
    return origin.plus(new Vec2(metres, 0).rotated(direction));
  }

  private static OccupancyGrid strewn(Random random) {
    BitSet walls = new BitSet();
    for (int i = 0; i < 60; i++) {
      walls.set(random.nextInt(400));
    }
    return new OccupancyGrid(20, 20, 0.3, new Vec2(-2, 5), walls);
  }
}
