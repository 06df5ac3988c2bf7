package org.toqa.exploration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.exploration.ExplorationDrive.State;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.PlanResult;

@Tag("full")
class ExplorationDriveTest {

  @ParameterizedTest
  @CsvSource({"OFFICE,1,1", "OFFICE,1,2", "OFFICE,4,1", "STORE,1,1", "STORE,4,2", "STORE,9,1"})
  void aSwarmArrivesWholeAndItsMapLeadsARobotTheSameWay(
      HiddenGround ground, int robots, long seed) {
    ExplorationOrder order = new ExplorationOrder(robots, ground.start(), ground.target(), seed);
    ExplorationDrive drive = new ExplorationDrive(ground.grid(), order);
    Disc body = new Disc(ExplorationDrive.ROBOT_RADIUS);
    while (drive.step() == State.DRIVING) {
      if (drive.picture().seconds() % 5 < ExplorationDrive.STEP) {
        drive
            .picture()
            .robots()
            .forEach(r -> assertTrue(body.isFreeAt(ground.grid(), r.position())));
      }
    }

    assertEquals(State.REACHED, drive.step());
    ExplorationPicture end = drive.picture();
    assertEquals(robots, end.robots().size());
    assertEquals(Math.min(3, robots), end.robots().stream().filter(r -> r.sees()).count());
    assertEquals(1, end.share());
    OccupancyGrid drawn = end.seen().map(List.of());
    assertNothingFreeIsWall(ground.grid(), drawn);
    OccupancyGrid inflated = Inflation.inflate(drawn, ExplorationDrive.ROBOT_RADIUS);
    assertInstanceOf(
        PlanResult.Found.class,
        new JumpPointSearch()
            .plan(inflated, inflated.cellAt(order.start()), inflated.cellAt(order.target())));
  }

  private static void assertNothingFreeIsWall(OccupancyGrid truth, OccupancyGrid drawn) {
    for (int row = 0; row < drawn.height(); row++) {
      for (int column = 0; column < drawn.width(); column++) {
        Vec2 middle = drawn.centre(new Cell(column, row));
        assertTrue(!drawn.isFree(column, row) || truth.isFree(middle), () -> middle.toString());
      }
    }
  }

  @Test
  void theSameSeedGivesTheSameDrive() {
    assertEquals(driven(7), driven(7));
    assertFalse(driven(7).equals(driven(8)));
  }

  private static ExplorationPicture driven(long seed) {
    ExplorationDrive drive =
        new ExplorationDrive(
            HiddenGround.OFFICE.grid(),
            new ExplorationOrder(
                2, HiddenGround.OFFICE.start(), HiddenGround.OFFICE.target(), seed));
    for (int i = 0; i < 50; i++) {
      drive.step();
    }
    return drive.picture();
  }

  @Test
  void whereNoWayIsWideEnoughItSaysSoWhenItHasSeenThat() {
    ExplorationDrive nine = // doors are 2 m, nine robots 2.6 m wide
        new ExplorationDrive(
            HiddenGround.OFFICE.grid(),
            new ExplorationOrder(9, new Vec2(3.5, 2), HiddenGround.OFFICE.target(), 1));
    while (nine.step() == State.DRIVING) {
      assertTrue(nine.picture().seconds() < 600);
    }
    assertEquals(State.NO_WAY, nine.step());
    assertEquals(9, nine.picture().robots().size());
  }

  @Test
  void aTargetInAWallIsNotReached() {
    BitSet walls = new BitSet();
    walls.set(5 * 40, 5 * 40 + 20);
    OccupancyGrid truth = new OccupancyGrid(40, 20, 0.2, Vec2.ZERO, walls);
    ExplorationDrive drive =
        new ExplorationDrive(truth, new ExplorationOrder(1, new Vec2(1, 1), new Vec2(1.1, 2.9), 1));
    while (drive.step() == State.DRIVING) {
      assertTrue(drive.picture().seconds() < 600);
    }
    assertEquals(State.NO_WAY, drive.step());
  }

  @Test
  void whatIsNoGroundForItIsToldBefore() {
    OccupancyGrid truth = HiddenGround.OFFICE.grid();
    Vec2 target = HiddenGround.OFFICE.target();
    assertTrue(ExplorationDrive.fits(truth, new ExplorationOrder(1, new Vec2(2, 2), target, 1)));
    assertFalse( // a wall
        ExplorationDrive.fits(truth, new ExplorationOrder(1, new Vec2(6.1, 2), target, 1)));
    assertFalse( // nine are wider than the place
        ExplorationDrive.fits(truth, new ExplorationOrder(9, new Vec2(1, 1), target, 1)));
    assertFalse(ExplorationDrive.fits(truth, new ExplorationOrder(1, new Vec2(-5, 2), target, 1)));
    assertTrue(
        ExplorationDrive.isSimulated(new OccupancyGrid(100, 100, 1, Vec2.ZERO, new BitSet())));
    assertFalse(
        ExplorationDrive.isSimulated(new OccupancyGrid(110, 110, 1, Vec2.ZERO, new BitSet())));
    assertFalse(
        ExplorationDrive.isSimulated(
            new OccupancyGrid(1 << 20, 1, 100_000, Vec2.ZERO, new BitSet())));
  }
}
