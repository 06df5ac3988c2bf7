package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

class PathQueryTest {
  private static final double DIAMETER = 0.9;
  private static final Vec2 WEST = new Vec2(0.5, 0.5);
  private static final Vec2 EAST = new Vec2(4.5, 0.5);

  private final OrderChecks.Check check =
      new OrderChecks(Runnable::run, 1, System::nanoTime).begin("Clara");
  private final PathQuery paths = new PathQuery(Runnable::run);

  @Test
  void aPathBeginsAtItsStartAndEndsAtItsGoal() {
    FloorPath.Found found =
        assertInstanceOf(FloorPath.Found.class, path(OccupancyGrid.parse(".....")));

    assertEquals(WEST, found.points().getFirst());
    assertEquals(EAST, found.points().getLast());
  }

  @Test
  void anEqualQuestionIsNotPlannedAgain() {
    assertSame(path(OccupancyGrid.parse(".....")), path(OccupancyGrid.parse(".....")));
  }

  @Test
  void anotherMapIsAnotherQuestion() {
    assertInstanceOf(FloorPath.Found.class, path(OccupancyGrid.parse(".....")));
    assertInstanceOf(FloorPath.NotFound.class, path(OccupancyGrid.parse("..#..")));
  }

  private FloorPath path(OccupancyGrid grid) {
    return paths.findPath(grid, WEST, EAST, DIAMETER, check).join();
  }
}
