package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.floor.ObstacleMap.Obstacle;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

class ObstacleMapTest {
  private static final BitSet NOBODY = new BitSet();
  private static final Instant START = Instant.EPOCH;

  /** Cells of 1 m; the lower left corner of the picture is (0, 0). */
  private static final OccupancyGrid GRID =
      OccupancyGrid.parse(
          "......", //
          "..#...", "......");

  private final ObstacleMap map = new ObstacleMap(GRID);

  @Test
  void aPerceptMarksTheCellThatItLiesIn() {
    List<Obstacle> appeared =
        map.addPercepts("r1", List.of(new Vec2(4.9, 0.1)), NOBODY::get, START);

    assertEquals(List.of(new Obstacle(new Cell(4, 2), "r1", START)), appeared);
    assertEquals(cells(new Cell(4, 2)), map.cells());
  }

  @Test
  void pointsOffTheMapAndInWallsSayNothing() {
    List<Vec2> percepts =
        List.of(
            new Vec2(2.5, 1.5), // the wall
            new Vec2(-0.1, 0.5),
            new Vec2(6.1, 0.5),
            new Vec2(0.5, 3.2),
            new Vec2(9e15, -9e15));

    assertEquals(List.of(), map.addPercepts("r1", percepts, NOBODY::get, START));
    assertTrue(map.cells().isEmpty());
  }

  @Test
  void whatIsSeenWhereAnotherRobotIsIsThatRobot() {
    BitSet others = cells(new Cell(4, 2));

    assertEquals(List.of(), map.addPercepts("r1", List.of(new Vec2(4.5, 0.5)), others::get, START));
    assertTrue(map.cells().isEmpty());
  }

  @Test
  void cellsThatTouchAreOneObstacle() {
    map.addPercepts("r1", List.of(new Vec2(3.5, 0.5)), NOBODY::get, START);

    List<Obstacle> later =
        map.addPercepts(
            "r2",
            List.of(new Vec2(4.5, 1.5), new Vec2(5.5, 2.5), new Vec2(0.5, 0.5)),
            NOBODY::get,
            START);

    assertEquals(List.of(new Obstacle(new Cell(0, 2), "r2", START)), later);
    assertEquals(4, map.cells().cardinality());
  }

  @Test
  void whatIsNotSeenAgainIsForgotten() {
    Obstacle obstacle =
        map.addPercepts("r1", List.of(new Vec2(0.5, 0.5)), NOBODY::get, START).getFirst();
    Instant end = START.plus(ObstacleMap.REMEMBER_FOR);

    assertEquals(List.of(), map.forgetExpired(end.minusMillis(1)));
    assertEquals(1, map.cells().cardinality());
    assertEquals(List.of(obstacle), map.forgetExpired(end));
    assertTrue(map.cells().isEmpty());
    assertEquals(List.of(), map.forgetExpired(end));
  }

  @Test
  void whatIsSeenAgainStays() {
    Vec2 there = new Vec2(0.5, 0.5);
    Obstacle obstacle = map.addPercepts("r1", List.of(there), NOBODY::get, START).getFirst();
    Instant again = START.plusSeconds(20);

    assertEquals(List.of(), map.addPercepts("r2", List.of(there), NOBODY::get, again));
    assertEquals(List.of(), map.forgetExpired(START.plus(ObstacleMap.REMEMBER_FOR)));
    assertEquals(List.of(obstacle), map.forgetExpired(again.plus(ObstacleMap.REMEMBER_FOR)));
  }

  @Test
  void anObstacleIsGoneOnceWhenItsLastCellIs() {
    Vec2 first = new Vec2(3.5, 0.5);
    Vec2 second = new Vec2(4.5, 0.5);
    Vec2 third = new Vec2(5.5, 0.5);
    map.addPercepts("r1", List.of(first, second), NOBODY::get, START);
    Instant later = START.plusSeconds(10);
    map.addPercepts("r1", List.of(third), NOBODY::get, later);

    assertEquals(List.of(), map.forgetExpired(START.plus(ObstacleMap.REMEMBER_FOR)));
    assertEquals(cells(new Cell(5, 2)), map.cells());
    assertEquals(1, map.forgetExpired(later.plus(ObstacleMap.REMEMBER_FOR)).size());
  }

  @Test
  void aRobotThatSeesObstaclesEverywhereDoesNotFillTheMemory() {
    OccupancyGrid hall = new OccupancyGrid(100, 100, 1, Vec2.ZERO, new BitSet());
    ObstacleMap ofHall = new ObstacleMap(hall);
    List<Vec2> everywhere = new ArrayList<>();
    for (int i = 0; i < 100 * 100; i++) {
      everywhere.add(hall.centre(hall.cell(i)));
    }

    ofHall.addPercepts("r1", everywhere, NOBODY::get, START);

    assertEquals(ObstacleMap.MAX_CELLS, ofHall.cells().cardinality());
  }

  @Test
  void aRobotThatSeesObstaclesEverywhereTakesNoPlaceFromOthers() {
    OccupancyGrid hall = new OccupancyGrid(100, 100, 1, Vec2.ZERO, new BitSet());
    ObstacleMap ofHall = new ObstacleMap(hall);
    List<Vec2> everywhere = new ArrayList<>();
    for (int i = 0; i < 5_000; i++) {
      everywhere.add(hall.centre(hall.cell(i)));
    }
    ofHall.addPercepts("r1", everywhere, NOBODY::get, START);

    ofHall.addPercepts("r2", List.of(hall.centre(hall.cell(9_999))), NOBODY::get, START);

    assertTrue(ofHall.cells().get(9_999));
  }

  @Test
  void whatOneRobotAloneSeesForLongIsDoubtedAndToldOnce() {
    Vec2 there = new Vec2(3.5, 0.5);
    Obstacle obstacle = map.addPercepts("r1", List.of(there), NOBODY::get, START).getFirst();
    Instant end = watch(START, ObstacleMap.BELIEVE_ONE_FOR.minusSeconds(1), there);
    assertEquals(cells(new Cell(3, 2)), map.cells());
    assertEquals(List.of(), map.takeDoubted());

    end = watch(end, Duration.ofSeconds(30), there);

    assertEquals(new BitSet(), map.cells());
    assertEquals(List.of(obstacle), map.takeDoubted());
    assertEquals(List.of(), map.takeDoubted());
    assertEquals(List.of(), map.forgetExpired(end), "it is still seen");
  }

  @Test
  void whoSeesSomethingElseBesideItIsDoubtedTheSame() {
    Instant now = START;
    for (int i = 0; i < 60; i++) { // each cell rests for a minute in between
      for (double x : new double[] {3.5, 4.5, 5.5}) {
        map.addPercepts("r1", List.of(new Vec2(x, 0.5)), NOBODY::get, now);
        map.forgetExpired(now);
        now = now.plusSeconds(20);
      }
    }

    assertEquals(new BitSet(), map.cells());
  }

  @Test
  void whatAnotherOneSeesTooIsBelievedAnew() {
    Vec2 there = new Vec2(3.5, 0.5);
    Instant end = watch(START, ObstacleMap.BELIEVE_ONE_FOR.plusSeconds(30), there);
    assertEquals(new BitSet(), map.cells());

    map.addPercepts("r2", List.of(there), NOBODY::get, end);
    assertEquals(cells(new Cell(3, 2)), map.cells());
    watch(end, Duration.ofMinutes(5), there);
    assertEquals(cells(new Cell(3, 2)), map.cells(), "r2 has gone, but was right");
  }

  @Test
  void whoLooksAwayForAWhileIsBelievedAnew() {
    Vec2 there = new Vec2(3.5, 0.5);
    Instant end =
        watch(START, ObstacleMap.BELIEVE_ONE_FOR.plusSeconds(30), there)
            .plus(ObstacleMap.REMEMBER_FOR);
    map.forgetExpired(end);

    map.addPercepts("r1", List.of(there), NOBODY::get, end);

    assertEquals(cells(new Cell(3, 2)), map.cells());
  }

  private Instant watch(Instant begin, Duration time, Vec2 there) {
    Instant now = begin;
    for (; !now.isAfter(begin.plus(time)); now = now.plusSeconds(10)) {
      map.addPercepts("r1", List.of(there), NOBODY::get, now);
      map.forgetExpired(now);
    }
    return now;
  }

  private static BitSet cells(Cell... cells) {
    BitSet bits = new BitSet();
    for (Cell cell : cells) {
      bits.set(GRID.index(cell));
    }
    return bits;
  }
}
