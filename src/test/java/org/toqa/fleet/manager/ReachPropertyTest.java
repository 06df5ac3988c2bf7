package org.toqa.fleet.manager;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;

/** Which part of a floor counts, against all parts looked at one by one. */
class ReachPropertyTest {
  private static final int SIDE = 1000;

  @Property
  void thePartWithMostPlacesCountsAndOfSeveralTheLargest(
      @ForAll @IntRange(min = 1, max = 9) int width,
      @ForAll @IntRange(min = 1, max = 9) int height,
      @ForAll @IntRange(min = 0, max = 5) int count,
      @ForAll long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid =
        OccupancyGrid.parse(
            IntStream.range(0, height).mapToObj(_ -> row(width, random)).toArray(String[]::new));
    List<Place> places =
        IntStream.range(0, count)
            .mapToObj(
                i ->
                    place(
                        "P" + i,
                        random.nextInt(width) + random.nextDouble(),
                        random.nextInt(height) + random.nextDouble()))
            .toList();

    assertEquals(slowly(grid, places), Reach.of(grid, places).connected());
  }

  private static String row(int width, Random random) {
    StringBuilder row = new StringBuilder();
    for (int column = 0; column < width; column++) {
      row.append(random.nextInt(5) < 2 ? '@' : '.');
    }
    return row.toString();
  }

  private static BitSet slowly(OccupancyGrid walls, List<Place> places) {
    OccupancyGrid room = Inflation.inflate(walls, PlaceCheck.SMALLEST_RADIUS);
    BitSet seen = room.occupied();
    BitSet best = new BitSet();
    long most = -1;
    for (int start = 0; start < room.width() * room.height(); start++) {
      if (seen.get(start)) {
        continue;
      }
      BitSet part = new BitSet();
      addReached(room, room.cell(start), part);
      seen.or(part);
      long found =
          places.stream()
              .filter(
                  place ->
                      room.cellsAround(place.position(), 1).stream()
                          .anyMatch(cell -> part.get(room.index(cell))))
              .count();
      if (found > most || (found == most && part.cardinality() > best.cardinality())) {
        best = part;
        most = found;
      }
    }
    return best;
  }

  private static void addReached(OccupancyGrid room, Cell cell, BitSet part) {
    if (!room.contains(cell) || !room.isFree(cell) || part.get(room.index(cell))) {
      return;
    }
    part.set(room.index(cell));
    addReached(room, new Cell(cell.column() + 1, cell.row()), part);
    addReached(room, new Cell(cell.column() - 1, cell.row()), part);
    addReached(room, new Cell(cell.column(), cell.row() + 1), part);
    addReached(room, new Cell(cell.column(), cell.row() - 1), part);
  }

  /** A bit set for each of the parts would be 15 GB. */
  @Example
  void manySmallPartsNeedNoMoreMemoryThanTheirFloor() {
    String walls = "@".repeat(SIDE);
    String cells = "@.".repeat(SIDE / 2);
    OccupancyGrid grid =
        OccupancyGrid.parse(
            IntStream.range(0, SIDE)
                .mapToObj(i -> i % 2 == 0 ? walls : cells)
                .toArray(String[]::new));
    List<Place> places =
        IntStream.range(0, 400).mapToObj(i -> place("P" + i, 2 * i + 1.5, 0.5)).toList();
    ThreadMXBean memory = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long before = memory.getCurrentThreadAllocatedBytes();

    Reach reach = Reach.of(grid, places);

    long allocated = memory.getCurrentThreadAllocatedBytes() - before;
    assertEquals(1, reach.connected().cardinality());
    assertTrue(allocated < 200_000_000, () -> allocated + " bytes");
  }

  private static Place place(String name, double x, double y) {
    return new Place(name, new Vec2(x, y));
  }
}
