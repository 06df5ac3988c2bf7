package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;

/** What the loops of a tick look at, as the floor and its robots grow alike: counted, not timed. */
class TickCostTest {
  private static final double DIAMETER = 0.255;

  /** Robots to a row; a row apart from the next. */
  private static final int PER_ROW = 5;

  private static final int SPACING = 4;

  private final List<TrafficRobot> robots = new ArrayList<>();

  /** A robot on each fourth cell, on a path of three cells east. */
  private Claims floorWith(int count) {
    int rows = 2 * (count / PER_ROW);
    OccupancyGrid unit = OccupancyGrid.parse(".".repeat(SPACING * PER_ROW));
    OccupancyGrid grid =
        new OccupancyGrid(SPACING * PER_ROW, rows, DrivenFloor.CELL, Vec2.ZERO, unit.occupied());
    for (int i = 0; i < count; i++) {
      Vec2 at = grid.centre(new Cell(SPACING * (i % PER_ROW), 2 * (i / PER_ROW)));
      Pose pose = new Pose(at.x(), at.y(), 0);
      TrafficRobot robot =
          new TrafficRobot("r" + i, i + 1, grid, pose, DIAMETER / 2, Instant.EPOCH);
      robot.continueOn(ReservedPath.independent(pose, sections(robot, pose)));
      robots.add(robot);
    }
    return new Claims(robots);
  }

  private static List<Section> sections(TrafficRobot robot, Pose start) {
    List<Section> sections = new ArrayList<>();
    Pose pose = start;
    for (int i = 0; i < 3; i++) {
      Segment cell = new Segment(0.25, 0, DrivenFloor.CELL / 0.25);
      SweptArea area = robot.sweptArea(pose, cell);
      pose = pose.advanced(cell.twist(), cell.t());
      sections.add(robot.section(List.of(cell), pose, area, false));
    }
    return sections;
  }

  /** Each asks for its next section. */
  private long comparisonsOfAll(Claims claims) {
    long before = claims.comparisons();
    for (TrafficRobot robot : robots) {
      Section next = Objects.requireNonNull(robot.drive.path()).sections().getFirst();
      assertTrue(claims.tooNear(robot, robot.standingArea(), next.area()).isEmpty());
    }
    return claims.comparisons() - before;
  }

  /** Only what has changed is read again. */
  @ParameterizedTest
  @ValueSource(ints = {50, 100, 200})
  void asManyAreReadAsHaveMoved(int count) {
    Claims claims = floorWith(count);
    claims.refresh();
    assertEquals(count, claims.readings());

    claims.refresh();
    assertEquals(count, claims.readings(), "nobody has moved");

    for (TrafficRobot robot : robots.subList(0, 10)) {
      Vec2 on = robot.pose().position().plus(new Vec2(0.1, 0));
      robot.setPose(new Pose(on.x(), on.y(), 0), robot.radius());
    }
    claims.refresh();
    assertEquals(count + 10, claims.readings());

    robots.getFirst().drive.releaseNext(Instant.EPOCH);
    robots.getLast().freeUnreleased();
    claims.refresh();
    assertEquals(count + 11, claims.readings(), "what was not released was nobody's yet");
  }

  /** Asking for a section looks at what is near to it, however many robots there are. */
  @Test
  void whatIsAskedCostsAsMuchAsThereIsNear() {
    Claims fifty = floorWith(50);
    fifty.refresh();
    long ofFifty = comparisonsOfAll(fifty);
    robots.clear();
    Claims twoHundred = floorWith(200);
    twoHundred.refresh();
    long ofTwoHundred = comparisonsOfAll(twoHundred);
    // four times as many robots on four times the floor: by the rows at the edge a little more
    assertTrue(ofTwoHundred <= 4.2 * ofFifty, ofTwoHundred + " after " + ofFifty);
    assertTrue(ofFifty <= 50 * 10, ofFifty + " of fifty");
  }

  /** A picture shares all that does not change with what it was made from. */
  @Test
  void aPictureSharesThePaths() {
    floorWith(50);
    for (TrafficRobot robot : robots) {
      TrafficRobot copy = robot.copy();
      assertSame(robot.drive.path(), copy.drive.path());
    }
  }
}
