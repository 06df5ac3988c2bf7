package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.RoadGraph;

class JointPlanTest {
  private static final double DIAMETER = 0.255;

  private final OccupancyGrid floor = DrivenFloor.draw("....", "....", "....");
  private final LaneGrid lanes = LaneGrid.of(floor, DIAMETER, Margins.USUAL.robot());
  private final RoadGraph roads = lanes.roads(new BitSet());

  /**
   * Into a cell, round a block of four in one curve, back through the same cell and out as it came:
   * where the curve ends, the robot is in that cell for the second time.
   */
  @Test
  void aLoopEndsInTheLaterVisitOfItsCell() {
    ReservedPath course =
        course(
            new Cell(0, 1),
            new Cell(1, 1),
            new Cell(1, 0),
            new Cell(2, 0),
            new Cell(2, 1),
            new Cell(1, 1),
            new Cell(0, 1));
    assertEquals(List.of(4, 5, 5, 6), course.visitAtEnd());
    assertEquals(List.of(true, false, true, false), halfway(course));
  }

  @Test
  void aStraightIsCutInTheMiddleOfEachCellAndBetweenThem() {
    ReservedPath course = course(new Cell(0, 1), new Cell(1, 1), new Cell(2, 1), new Cell(3, 1));
    assertEquals(List.of(0, 1, 1, 2, 2, 3), course.visitAtEnd());
    assertEquals(List.of(true, false, true, false, true, false), halfway(course));
  }

  @Test
  void backTheWayItCameIsAVisitOfEachCellAgain() {
    ReservedPath course = course(new Cell(0, 1), new Cell(1, 1), new Cell(0, 1));
    assertEquals(List.of(0, 1, 1, 1, 2), course.visitAtEnd());
  }

  /** Nobody may stop before a curve and keep the way through its cell: another could come there. */
  @Test
  void aCurveIsDrivenWithThePassageBeforeIt() {
    ReservedPath course = course(new Cell(0, 1), new Cell(1, 1), new Cell(2, 1), new Cell(2, 0));
    assertEquals(List.of(0, 1, 2, 3), course.visitAtEnd());
    assertEquals(List.of(true, false, true, false), halfway(course));
  }

  private static List<Boolean> halfway(ReservedPath course) {
    return course.sections().stream().map(Section::endsHalfway).toList();
  }

  /** The course of one robot that has the floor for itself and faces east. */
  private ReservedPath course(Cell... visits) {
    Vec2 start = floor.centre(visits[0]);
    TrafficRobot robot =
        new TrafficRobot(
            "r", 1, floor, new Pose(start.x(), start.y(), 0), DIAMETER / 2, Instant.EPOCH);
    List<int[]> steps = List.of(visits).stream().map(c -> new int[] {roads.vertex(c)}).toList();
    new JointPlan(
            new FreeSpace(floor, Margins.USUAL),
            lanes.points(new BitSet()),
            new OccupiedSpace(floor, new BitSet(), List.of()),
            roads,
            lanes.spacing(roads),
            List.of(robot),
            steps)
        .adopt(new SectionFitter());
    return Objects.requireNonNull(robot.drive.path());
  }
}
