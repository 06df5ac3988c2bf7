package org.toqa.planning.cmct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.cmct.LatticeResult.Found;
import org.toqa.planning.cmct.LatticeResult.NotFound;
import org.toqa.planning.cmct.LatticeResult.Reason;
import org.toqa.planning.exact.ShortestDiscPath;

class CmctWalkTest {
  /** Metres: as good as a point. */
  private static final double POINT = 1e-6;

  @Test
  void withoutObstaclesTenDiagonalsAreTheStraightLine() {
    OccupancyGrid store = store(new BitSet());
    Cell start = new Cell(1, 8);
    Cell goal = new Cell(7, 3);
    StepLattice lattice = StepLattice.ofTenths(store, start, goal);

    Found found = found(CmctWalk.plan(lattice, lattice.pointOf(start), lattice.pointOf(goal)));

    assertEquals(6.0, lattice.stepX(), 1e-12); // 60 m / 10
    assertEquals(5.0, lattice.stepY(), 1e-12); // 50 m / 10
    assertEquals(11, found.points().size());
    assertEquals(Math.hypot(60, 50), lattice.length(found.points()), 1e-9);
    assertEquals(10, found.effort().visited());
    assertEquals(new Vec2(15, 15), lattice.position(found.points().getFirst()));
    assertEquals(new Vec2(75, 65), lattice.position(found.points().getLast()));
  }

  /** To the south the wall ends after two cells, to the north after four. */
  @Test
  void goesRoundAWallTheShorterWay() {
    OccupancyGrid grid =
        OccupancyGrid.parse(
            ".......", ".......", "...#...", "...#...", "...#...", "...#...", "...#...", ".......",
            ".......");
    StepLattice cells = StepLattice.ofCells(grid);

    Found found = found(CmctWalk.plan(cells, new Cell(1, 5), new Cell(5, 5)));

    List<Cell> expected = new ArrayList<>();
    int[][] points = {{1, 5}, {2, 5}, {2, 6}, {2, 7}, {3, 7}, {4, 7}, {5, 6}, {5, 5}};
    for (int[] point : points) {
      expected.add(new Cell(point[0], point[1]));
    }
    assertEquals(expected, found.points());
    // six straight steps and a diagonal; the shortest has four and two
    assertEquals(6 + Math.sqrt(2), cells.length(found.points()), 1e-9);
    Found shortest = found(LatticeAStar.plan(cells, new Cell(1, 5), new Cell(5, 5)));
    assertEquals(4 + 2 * Math.sqrt(2), cells.length(shortest.points()), 1e-9);
  }

  @Test
  void aGoalInAClosedRoomHasNoPath() {
    StepLattice cells =
        StepLattice.ofCells(OccupancyGrid.parse(".....", ".###.", ".#.#.", ".###.", "....."));

    NotFound none =
        assertInstanceOf(NotFound.class, CmctWalk.plan(cells, new Cell(0, 0), new Cell(2, 2)));

    assertEquals(Reason.NO_PATH, none.reason());
  }

  @Test
  void thereIsNoTenthOfNoWay() {
    OccupancyGrid store = store(new BitSet());

    assertThrows(
        IllegalArgumentException.class,
        () -> StepLattice.ofTenths(store, new Cell(1, 1), new Cell(1, 1)));
    assertThrows(
        IllegalArgumentException.class,
        () -> StepLattice.ofTenths(store, new Cell(1, 1), new Cell(10, 1)));
  }

  /** A* with the same moves is between the walk and the exact shortest; all three find a path. */
  @Property(tries = 300)
  void walkIsNeverShorterThanTheShortest(
      @ForAll long seed, @ForAll @DoubleRange(min = 0, max = 0.4) double density) {
    Random random = new Random(seed);
    BitSet occupied = new BitSet();
    for (int i = 0; i < 100; i++) {
      occupied.set(i, random.nextDouble() < density);
    }
    Cell start = new Cell(random.nextInt(10), random.nextInt(10));
    Cell goal = new Cell((start.column() + 1 + random.nextInt(9)) % 10, random.nextInt(10));
    OccupancyGrid store = store(occupied);
    occupied.clear(store.index(start));
    occupied.clear(store.index(goal));
    store = store(occupied);
    StepLattice lattice = StepLattice.ofTenths(store, start, goal);
    Cell from = lattice.pointOf(start);
    Cell to = lattice.pointOf(goal);

    LatticeResult walk = CmctWalk.plan(lattice, from, to);
    LatticeResult search = LatticeAStar.plan(lattice, from, to);
    OptionalDouble exact =
        new ShortestDiscPath(store, POINT).length(store.centre(start), store.centre(goal));

    assertEquals(exact.isPresent(), walk instanceof Found);
    assertEquals(exact.isPresent(), search instanceof Found);
    if (exact.isPresent()) {
      double walked = assertLegal(store, lattice, found(walk).points());
      double searched = assertLegal(store, lattice, found(search).points());
      assertTrue(searched >= exact.getAsDouble() - 1e-6, searched + " is too short");
      assertTrue(walked >= searched - 1e-9, walked + " is too short");
    }
  }

  /** By lines and squares alone; the length in metres. */
  private static double assertLegal(OccupancyGrid store, StepLattice lattice, List<Cell> points) {
    double length = 0;
    for (int i = 1; i < points.size(); i++) {
      Vec2 from = lattice.position(points.get(i - 1));
      Vec2 to = lattice.position(points.get(i));
      assertTrue(Math.abs(to.x() - from.x()) < lattice.stepX() + 1e-9);
      assertTrue(Math.abs(to.y() - from.y()) < lattice.stepY() + 1e-9);
      for (int piece = 0; piece <= 100; piece++) {
        Vec2 point = from.plus(to.minus(from).times(piece / 100.0));
        assertTrue(store.isFree(point), () -> point + " is not free");
      }
      length += from.distanceTo(to);
    }
    return length;
  }

  private static Found found(LatticeResult result) {
    return assertInstanceOf(Found.class, result);
  }

  private static OccupancyGrid store(BitSet occupied) {
    return new OccupancyGrid(10, 10, 10, Vec2.ZERO, occupied);
  }
}
