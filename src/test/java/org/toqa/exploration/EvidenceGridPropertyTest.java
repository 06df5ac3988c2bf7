package org.toqa.exploration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

class EvidenceGridPropertyTest {
  private static final double CELL = 0.1;

  /** Cells of the map are quarters of those of the ground. */
  @Property(tries = 60)
  void whatIsFreeWasSeenAndIsFreeInTruth(
      @ForAll long seed,
      @ForAll @DoubleRange(min = 0.4, max = 3.6) double x,
      @ForAll @DoubleRange(min = 0.4, max = 2.6) double y) {
    OccupancyGrid truth = ground(new Random(seed), new Vec2(x, y));
    EvidenceGrid map = new EvidenceGrid(40, 30, CELL, truth.origin());
    for (int ray = 0; ray < 360; ray++) {
      double direction = Math.toRadians(ray);
      double range = RayCast.distance(truth, new Vec2(x, y), direction, 2);
      map.addRay(new Vec2(x, y), direction, range, range < 2);
      map.addRay(new Vec2(x, y), direction, range, range < 2);
    }
    SeenGround seen = map.seen();
    OccupancyGrid frame = map.optimistic();
    for (int cell : seen.free().cells().stream().toArray()) {
      Vec2 middle = frame.centre(frame.cell(cell));
      assertTrue(truth.isFree(middle), () -> middle + " is a wall");
      assertTrue(middle.distanceTo(new Vec2(x, y)) < 2 + CELL, () -> middle + " was not seen");
    }
    for (int cell : seen.occupied().cells().stream().toArray()) {
      Cell at = frame.cell(cell);
      assertTrue(
          frame.cellsAround(frame.centre(at), 1).stream()
              .anyMatch(near -> !truth.isFree(frame.centre(near))),
          () -> "nothing is at " + at);
    }
  }

  /** One that is exactly diagonal passes corners of walls. */
  @Example
  void aRayThatTouchesACornerTellsNothingOfTheCellBehind() {
    whatIsFreeWasSeenAndIsFreeInTruth(8, 1.33, 2.53);
  }

  private static OccupancyGrid ground(Random random, Vec2 free) {
    BitSet occupied = new BitSet();
    for (int i = 0; i < 40; i++) {
      occupied.set(random.nextInt(20 * 15));
    }
    OccupancyGrid grid = new OccupancyGrid(20, 15, 2 * CELL, Vec2.ZERO, occupied);
    occupied.clear(grid.index(grid.cellAt(free)));
    return grid.withOccupied(occupied);
  }

  /** The cells along a ray are those that many points along it lie in. */
  @Property(tries = 200)
  void aRayGoesThroughTheCellsThatItsPointsLieIn(
      @ForAll @DoubleRange(min = 0, max = 2) double x,
      @ForAll @DoubleRange(min = 0, max = 2) double y,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double direction) {
    Set<String> walked = new TreeSet<>();
    RayCast.walk(
        CELL,
        new Vec2(x, y),
        direction,
        1,
        (column, up, entered, left) -> {
          if (left - entered > 1e-6) { // else it only touches the corner
            walked.add(column + " " + up);
          }
          return true;
        });
    Set<String> sampled = new TreeSet<>();
    Vec2 along = new Vec2(1, 0).rotated(direction);
    for (int i = 0; i < 100_000; i++) {
      Vec2 at = new Vec2(x, y).plus(along.times(i / 100_000.0));
      sampled.add((int) Math.floor(at.x() / CELL) + " " + (int) Math.floor(at.y() / CELL));
    }
    assertTrue(walked.containsAll(sampled) || missesByRounding(walked, sampled));
    assertTrue(walked.size() <= sampled.size() + 2, () -> walked + ", but " + sampled);
  }

  /** Beside a corner a point may lie in a cell that the ray passes for less than a micrometre. */
  private static boolean missesByRounding(Set<String> walked, Set<String> sampled) {
    Set<String> missed = new TreeSet<>(sampled);
    missed.removeAll(walked);
    return missed.size() <= 1;
  }

  @Example
  void whatHasMovedAwayIsForgotten() {
    EvidenceGrid map = new EvidenceGrid(10, 1, CELL, Vec2.ZERO);
    Vec2 from = new Vec2(0.05, 0.05);
    for (int i = 0; i < 1000; i++) {
      map.addRay(from, 0, 0.45, true);
    }
    assertFalse(map.optimistic().isFree(5, 0));
    for (int i = 0; i < 12; i++) { // from 4 to -0.5, by 0.405
      map.addRay(from, 0, 0.9, false);
    }
    assertTrue(map.optimistic().isFree(5, 0));
    assertTrue(map.seen().free().cells().get(5));
  }

  @Example
  void unknownIsWallOnTheMapAndPlacesLieOnIt() {
    EvidenceGrid map = new EvidenceGrid(20, 10, CELL, new Vec2(-1, 0));
    map.addRay(new Vec2(-0.75, 0.55), 0, 0.5, true);
    map.addRay(new Vec2(-0.75, 0.55), 0, 0.5, true);

    OccupancyGrid drawn = map.seen().map(List.of(new Vec2(0.45, 0.25)));

    assertEquals(13, drawn.width()); // from the ray's begin at -0.8 to the place at 0.5
    assertEquals(4, drawn.height()); // from 0.2 to 0.6
    assertEquals(-0.8, drawn.origin().x(), 1e-9);
    assertEquals(0.2, drawn.origin().y(), 1e-9);
    assertTrue(drawn.isFree(new Vec2(-0.4, 0.55)));
    assertFalse(drawn.isFree(new Vec2(-0.22, 0.55)));
    assertFalse(drawn.isFree(new Vec2(0.45, 0.25)));
  }
}
