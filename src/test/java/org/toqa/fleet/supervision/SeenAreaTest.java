package org.toqa.fleet.supervision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;

/** What cameras have seen, and from where there is more to see. */
class SeenAreaTest {
  private static final double RANGE = 4;
  private static final double CLEARANCE = 0.2;

  /** Two rooms of cells of a metre; the door is at the northern end of the wall between them. */
  private static final OccupancyGrid ROOMS =
      OccupancyGrid.parse(
          "#########", //
          "#.......#",
          "#...#...#",
          "#...#...#",
          "#...#...#",
          "#########");

  private static final Vec2 WEST = new Vec2(2.5, 1.5);
  private static final Vec2 DOOR = new Vec2(4.5, 4.5);
  private static final Vec2 EAST = new Vec2(6.5, 1.5);

  private final SeenArea seen =
      new SeenArea(new FloorMap("rooms", ROOMS, List.of(), List.of(), List.of()), CLEARANCE, "");

  @Test
  void behindAWallNothingIsSeen() {
    seen.look(WEST, RANGE);

    assertFalse(seen.isComplete());
    assertTrue(seen.isView(EAST, RANGE));
    assertFalse(seen.isView(WEST, RANGE));
  }

  @Test
  void everythingIsSeenFromOneViewAfterTheOther() {
    Vec2 place = WEST;
    int views = 0;
    for (Optional<Vec2> next = Optional.of(place); next.isPresent(); views++) {
      place = next.get();
      seen.look(place, RANGE);
      next = seen.nextView(place, RANGE);
    }

    assertTrue(seen.isComplete());
    assertTrue(views > 1 && views < 10, views + " views");
  }

  @Test
  void whatWasSeenCountsOnTheSameCellsAlone() {
    seen.look(WEST, RANGE);

    assertTrue(of(ROOMS, seen.text()).share() > 0);
    Vec2 elsewhere = new Vec2(1, 0);
    OccupancyGrid shifted =
        new OccupancyGrid(ROOMS.width(), ROOMS.height(), 1, elsewhere, ROOMS.occupied());
    assertEquals(0, of(shifted, seen.text()).share());
    assertEquals(0, of(OccupancyGrid.parse(".........", "........."), seen.text()).share());
  }

  private static SeenArea of(OccupancyGrid walls, String text) {
    FloorMap floor = new FloorMap("rooms", walls, List.of(), List.of(), List.of());
    return new SeenArea(floor, CLEARANCE, text);
  }

  /** It was taken for seen what lies round it, behind walls too: boxes there were never found. */
  @Test
  void aViewThatIsGivenUpLeavesWhatCanBeSeenFromOthers() {
    seen.look(WEST, RANGE);
    Vec2 first = seen.nextView(WEST, RANGE).orElseThrow();

    seen.giveUp(first);

    Vec2 other = seen.nextView(WEST, RANGE).orElseThrow();
    assertFalse(seen.isComplete());
    assertTrue(other.distanceTo(first) > 0.5, other::toString);
    assertTrue(seen.isView(EAST, RANGE));
  }

  /** Else boxes that lie behind others would be taken for found nowhere. */
  @Test
  void whatLiesBehindABoxIsLookedForWhenThatIsCarriedAway() {
    seen.setBoxes(List.of(DOOR));
    for (Optional<Vec2> next = Optional.of(WEST); next.isPresent(); ) {
      assertTrue(next.get().x() < DOOR.x(), next::toString);
      seen.look(next.get(), RANGE);
      next = seen.nextView(next.get(), RANGE);
    }
    assertFalse(seen.isComplete());
    assertEquals(Optional.empty(), seen.nextView(WEST, RANGE));

    seen.setBoxes(List.of());
    assertTrue(seen.nextView(WEST, RANGE).isPresent());
  }

  @Test
  void whatNobodyCanSeeEndsTheSearch() {
    seen.look(WEST, RANGE);
    for (Optional<Vec2> next = seen.nextView(WEST, RANGE); next.isPresent(); ) {
      seen.giveUp(next.get());
      next = seen.nextView(WEST, RANGE);
    }

    assertTrue(seen.isComplete());
    assertEquals(1, seen.share(), 1e-9);
  }

  @Test
  void whatIsForgottenIsLookedForFromEverywhere() {
    seen.look(WEST, RANGE);
    Vec2 first = seen.nextView(WEST, RANGE).orElseThrow();
    seen.giveUp(first);

    seen.forget();

    assertTrue(seen.isView(first, RANGE));
    assertEquals(0, seen.share());
  }
}
