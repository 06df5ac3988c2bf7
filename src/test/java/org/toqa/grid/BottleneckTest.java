package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class BottleneckTest {
  /** Two rooms of cells of 1 m, a door of two cells above and one of a single cell below. */
  private static final OccupancyGrid ROOMS =
      OccupancyGrid.parse(
          "#################",
          "#.......#.......#",
          "#...............#",
          "#...............#",
          "#.......#.......#",
          "#...............#",
          "#.......#.......#",
          "#################");

  private static Optional<Bottleneck> between(double limit) {
    return Bottleneck.between(ROOMS, new Vec2(3.5, 4.5), new Vec2(13.5, 4.5), limit);
  }

  @Test
  void theWidestWayIsNarrowestInItsDoor() {
    Bottleneck door = between(3).orElseThrow();
    assertEquals(2, door.width(), 1e-9);
    assertEquals(8.5, door.place().x(), 0.51);
    assertEquals(5, door.place().y(), 1e-9); // between the third and the fourth row of eight
  }

  @Test
  void whatIsAsWideAsAskedForIsNotNarrow() {
    assertEquals(Optional.empty(), between(2));
    assertTrue(between(2.01).isPresent());
  }

  @Test
  void whereThereIsNoWayIsNoNarrowestPlace() {
    OccupancyGrid closed = OccupancyGrid.parse("..#..", "..#..", "..#..");
    assertEquals(Optional.empty(), Bottleneck.between(closed, new Vec2(1, 1), new Vec2(4, 1), 1));
  }
}
