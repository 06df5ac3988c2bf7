package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.List;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.PathLengths;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Direction;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;

/** Two halls of a floor, and the one gap in the wall between them, far to the north. */
class FloorDistancesTest {
  private static final double DIAMETER = 0.25;
  private static final Vec2 WEST = new Vec2(15, 0.5);
  private static final Vec2 EAST = new Vec2(25, 0.5);

  private final Queue<Runnable> elsewhere = new ArrayDeque<>();

  @Test
  void onALargeFloorAnAgentIsAnsweredAtOnceAndExactlyOnceThePathsAreFound() {
    FloorDistances distances = new FloorDistances(halls(400));
    PathLengths ofAgent = distances.withoutWaiting(elsewhere::add);

    assertEquals(10, ofAgent.lengthsTo(EAST, DIAMETER).applyAsDouble(WEST), 1e-9);
    assertEquals(10, ofAgent.lengthsTo(EAST, DIAMETER).applyAsDouble(WEST), 1e-9);
    assertEquals(1, elsewhere.size(), "it is looked for once");
    elsewhere.remove().run();

    double exact = distances.lengthsTo(EAST, DIAMETER).applyAsDouble(WEST);
    assertTrue(exact > 70, () -> "round the wall, not " + exact);
    assertEquals(exact, ofAgent.lengthsTo(EAST, DIAMETER).applyAsDouble(WEST), 1e-9);
    assertEquals(0, elsewhere.size());
  }

  @Test
  void onASmallFloorAnAgentIsAnsweredExactlyAtOnce() {
    PathLengths ofAgent = new FloorDistances(halls(50)).withoutWaiting(elsewhere::add);

    double exact =
        ofAgent.lengthsTo(new Vec2(3.5, 0.5), DIAMETER).applyAsDouble(new Vec2(1.5, 0.5));
    assertTrue(exact > 8, () -> "round the wall, not " + exact);
    assertEquals(0, elsewhere.size());
  }

  @Test
  void whereAnAreaIsDrivenOneWayLengthsAreThoseThatLeadToAPlace() {
    Area middle = new Area(new Vec2(0, 1), 5, 1);
    FloorDistances distances =
        new FloorDistances(
            new OccupancyGrid(50, 20, 0.1, Vec2.ZERO, new BitSet())
                .withRules(
                    new MoveRules(
                        List.of(new OneWay(middle, Direction.NORTH)), List.of(), List.of())));
    Vec2 south = new Vec2(2.55, 0.55);
    Vec2 north = new Vec2(2.55, 1.75);

    assertEquals(1.2, distances.length(south, north, DIAMETER), 1e-6);
    assertEquals(Double.POSITIVE_INFINITY, distances.length(north, south, DIAMETER));
    assertEquals(1.2, distances.lengthsTo(north, DIAMETER).applyAsDouble(south), 1e-6);
  }

  /** Square, of cells of 0.1 m; the wall is in the middle column and leaves the topmost 0.5 m. */
  private static OccupancyGrid halls(int side) {
    BitSet walls = new BitSet();
    for (int row = 5; row < side; row++) {
      walls.set(row * side + side / 2);
    }
    return new OccupancyGrid(side, side, 0.1, new Vec2(0, 0), walls);
  }
}
