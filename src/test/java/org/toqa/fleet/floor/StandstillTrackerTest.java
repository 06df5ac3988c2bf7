package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.floor.Standstill;
import org.toqa.traffic.floor.Standstill.Kind;

class StandstillTrackerTest {
  private static final int LONGEST_EVENT = 500; // as wide as the column of the history
  private static final OccupancyGrid GRID = OccupancyGrid.parse("....", "....");

  private static final StandstillTracker.Change NOTHING =
      new StandstillTracker.Change(List.of(), List.of());

  private final StandstillTracker report = new StandstillTracker(GRID);

  @Test
  void aNewOneIsToldWithRobotsAndPlaces() {
    StandstillView begun = report.update(List.of(ring("r1", "r2"))).begun().getFirst();

    assertEquals(List.of(new Vec2(0.5, 1.5), new Vec2(1.5, 1.5)), begun.positions());
    assertEquals(
        "r1, r2 at (0.50, 1.50), (1.50, 1.50) are blocking each other. Their paths are planned"
            + " again.",
        begun.text().english());
    assertEquals(List.of(begun), report.lasting());
  }

  @Test
  void whileItLastsNothingIsToldWhicheverRobotIsNamedFirst() {
    report.update(List.of(ring("r1", "r2")));

    assertEquals(NOTHING, report.update(List.of(ring("r2", "r1"))));
    assertEquals(List.of("r1", "r2"), report.lasting().getFirst().robots());
  }

  @Test
  void itsEndIsToldOnce() {
    report.update(List.of(new Standstill(Kind.NOT_MOVING, List.of("r1"), cells(1), Instant.EPOCH)));

    StandstillTracker.Change end = report.update(List.of());

    assertEquals(
        "The standstill of r1 is over.",
        StandstillTracker.endSentence(end.ended().getFirst()).english());
    assertEquals(NOTHING, report.update(List.of()));
  }

  @Test
  void aRingOfManyRobotsWithLongNamesFitsTheHistory() {
    List<String> names = IntStream.range(0, 40).mapToObj(i -> "r".repeat(60) + i).toList();

    StandstillView begun =
        report.update(List.of(ring(names.toArray(String[]::new)))).begun().getFirst();

    assertEquals(40, begun.robots().size());
    assertTrue(begun.text().english().contains(" and 36 more at "), begun.text()::english);
    assertTrue(begun.text().english().length() <= LONGEST_EVENT, begun.text()::english);
  }

  private static Standstill ring(String... robots) {
    return new Standstill(
        Kind.CYCLE_OF_WAITS, List.of(robots), cells(robots.length), Instant.EPOCH);
  }

  private static List<Cell> cells(int count) {
    return count <= 4
        ? IntStream.range(0, count).mapToObj(column -> new Cell(column, 0)).toList()
        : Collections.nCopies(count, new Cell(0, 0));
  }
}
