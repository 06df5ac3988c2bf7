package org.toqa.fleet.history;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorView.SeenObstacle;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.history.SeenPlaces.Offer;
import org.toqa.geometry.Pose;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.store.JdbiSightingStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;

class SeenPlacesTest {
  private static final Instant START = Instant.parse("2026-11-27T08:00:00Z");
  private static final FloorMap HALL = Hall.floor();
  private static final Cell CELL = new Cell(15, 9);

  private final SeenPlaces places = new SeenPlaces(Map.of());

  @Test
  void whatSeveralHaveSeenForLongIsOfferedAlsoWhenItWasForgottenMeanwhile() {
    observe(Duration.ZERO, seen(Duration.ZERO, "r1"));
    observe(Duration.ofMinutes(5));
    assertEquals(List.of(), places.offers(HALL));
    observe(Duration.ofMinutes(59), seen(Duration.ofMinutes(59), "r2"));
    assertEquals(List.of(), places.offers(HALL), "not for long");
    observe(Duration.ofMinutes(61), seen(Duration.ofMinutes(61), "r2"));

    Offer offer = places.offers(HALL).getFirst();
    assertEquals(List.of("r1", "r2"), offer.robots());
    assertEquals(START, offer.since());
    assertEquals(4, offer.cells().size());
  }

  @Test
  void whatOneAloneHasSeenIsNotOffered() {
    observe(Duration.ZERO, seen(Duration.ZERO, "r1"));
    observe(Duration.ofHours(9), seen(Duration.ofHours(9), "r1"));

    assertEquals(List.of(), places.offers(HALL));
  }

  @Test
  void whereARobotHasStoodSinceNothingIsOffered() {
    seeForLong();
    Pose there = new Pose(HALL.grid().centre(CELL).x(), HALL.grid().centre(CELL).y(), 0);
    RobotView robot = Hall.robot("r3", RobotState.DRIVING, there, "10.0.0.3", 7275);
    RobotView body = robot.withCapabilities(robot.capabilities().withFootprint(2));

    places.observe(
        HALL, Views.floorWith("hall", List.of()), List.of(body), START.plus(Duration.ofHours(3)));

    assertEquals(List.of(), places.offers(HALL));
  }

  @Test
  void whatIsDismissedIsOfferedNoMoreUntilItIsGoneAndComesAgain() {
    seeForLong();
    Offer offer = places.offers(HALL).getFirst();

    places.dismiss(HALL, offer);
    observe(Duration.ofHours(3), seen(Duration.ofHours(3), "r1", "r2"));
    assertEquals(List.of(), places.offers(HALL));

    Duration later = SeenPlaces.FORGET_AFTER.plusHours(4);
    observe(later);
    observe(later, seen(later, "r1", "r2"));
    observe(later.plusHours(2), seen(later.plusHours(2), "r1", "r2"));
    assertEquals(1, places.offers(HALL).size());
  }

  @Test
  void itIsKnownAfterARestart() throws Exception {
    seeForLong();
    try (var database = MemoryDatabase.open("sightings")) {
      JdbiSightingStore store = new JdbiSightingStore(database.jdbi());
      store.replace(places.takeChanged().orElseThrow());
      store.replace(places.takeChanged().orElse(store.sightings()));

      assertEquals(places.offers(HALL), new SeenPlaces(store.sightings()).offers(HALL));
    }
  }

  private void seeForLong() {
    observe(Duration.ZERO, seen(Duration.ZERO, "r1"));
    observe(Duration.ofHours(2), seen(Duration.ofHours(2), "r2"));
    assertEquals(1, places.offers(HALL).size());
  }

  private void observe(Duration after, SeenObstacle... seen) {
    places.observe(HALL, Views.floorWith("hall", List.of(seen)), List.of(), START.plus(after));
  }

  /** Two by two cells. */
  private static SeenObstacle seen(Duration after, String... robots) {
    BitSet cells = new BitSet();
    for (int i = 0; i < 4; i++) {
      cells.set(HALL.grid().index(new Cell(CELL.column() + i % 2, CELL.row() + i / 2)));
    }
    Instant at = START.plus(after);
    return new SeenObstacle(CellRuns.of(cells), List.of(robots), at, at, false);
  }
}
