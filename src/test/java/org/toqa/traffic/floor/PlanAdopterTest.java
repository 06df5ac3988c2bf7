package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.RoadGraph;

/**
 * Robot a drives east along the middle row when the floor is pictured; in the plan b, from the row
 * above, goes through that row before it.
 */
class PlanAdopterTest {
  private static final double DIAMETER = 0.255;
  private static final Instant NOW = Instant.EPOCH;

  private final OccupancyGrid floor = DrivenFloor.draw(".....", ".....", ".....");
  private final LaneGrid lanes = LaneGrid.of(floor, DIAMETER, Margins.USUAL.robot());
  private final RoadGraph roads = lanes.roads(new BitSet());
  private final Map<String, TrafficRobot> robots = new TreeMap<>();
  private final TrafficRobot a = robot("a", 1, new Cell(0, 1), new Cell(3, 1));
  private final TrafficRobot b = robot("b", 2, new Cell(2, 0), new Cell(2, 2));
  private final Claims claims = new Claims(robots.values());
  private final PlanAdopter adopter = new PlanAdopter(robots, claims, new ReplanTrigger());
  private FloorPlan plan;

  private TrafficRobot robot(String name, int number, Cell cell, Cell goal) {
    Vec2 at = floor.centre(cell);
    TrafficRobot robot =
        new TrafficRobot(name, number, floor, new Pose(at.x(), at.y(), 0), DIAMETER / 2, NOW);
    robot.setMovable(true);
    robot.setGoal(floor.centre(goal), null, NOW);
    robots.put(name, robot);
    return robot;
  }

  @BeforeEach
  void pictureAndPlan() {
    drive(
        List.of(a),
        List.of(List.of(at(0, 1)), List.of(at(1, 1)), List.of(at(2, 1)), List.of(at(3, 1))));
    List<TrafficRobot> pictured = List.of(a.copy(), b.copy());
    List<TrafficRobot> planned = pictured.stream().map(TrafficRobot::copy).toList();
    drive(
        planned,
        List.of(
            List.of(at(0, 1), at(2, 0)),
            List.of(at(1, 1), at(2, 1)),
            List.of(at(1, 1), at(2, 2)),
            List.of(at(2, 1), at(2, 2)),
            List.of(at(3, 1), at(2, 2))));
    ReplanTrigger.Need need = new ReplanTrigger.Need(true, false, false, true, false);
    plan =
        new FloorPlan(
            new PlanningRequest(NOW, Obstacles.NONE, pictured, Set.of(), need),
            List.of(
                ProposedPath.of(pictured.getFirst(), planned.getFirst()),
                ProposedPath.of(pictured.getLast(), planned.getLast())),
            LaneOutcome.PLANNED,
            Map.of("a", a.waiting.findings(), "b", b.waiting.findings()));
    claims.refresh();
  }

  private static Cell at(int column, int row) {
    return new Cell(column, row);
  }

  private void drive(List<TrafficRobot> together, List<List<Cell>> steps) {
    List<int[]> vertices =
        steps.stream().map(s -> s.stream().mapToInt(roads::vertex).toArray()).toList();
    new JointPlan(
            new FreeSpace(floor, Margins.USUAL),
            lanes.points(new BitSet()),
            new OccupiedSpace(floor, new BitSet(), List.of()),
            roads,
            lanes.spacing(roads),
            together,
            vertices)
        .adopt(new SectionFitter());
  }

  /** Of a's path: to the border of each cell, and on to its middle. */
  private void releaseCells(int cells) {
    for (int i = 0; i < 2 * cells; i++) {
      a.drive.releaseNext(NOW);
    }
  }

  private static ReservedPath path(TrafficRobot robot) {
    return Objects.requireNonNull(robot.drive.path());
  }

  @Test
  void whoHasNotGoneOnTakesItsPath() {
    assertTrue(adopter.adopt(plan, new BitSet()));
    assertEquals(2 * 3, path(a).sectionCount()); // to the border and on, three cells
    assertEquals(1 + 2 * 2, path(b).sectionCount()); // a turn on the spot and two cells
    assertEquals("b", path(a).dependencies().get(2).getFirst().robot());
  }

  /** It is in the cell before the one where it meets b, and still waits for b there. */
  @Test
  void whoHasGoneOnAlongItsPathTakesTheRest() {
    releaseCells(1);
    assertTrue(adopter.adopt(plan, new BitSet()));
    assertEquals(2, a.drive.released());
    assertEquals(2 * 3, path(a).sectionCount());
    assertEquals(1, path(a).visitAfterSections(2));
    assertEquals(2, path(a).visitAfterSections(4));
    assertEquals(
        List.of(new ReservedPath.Dependency("b", b.drive.pathNumber(), 1)),
        path(a).dependencies().get(2));
  }

  /** It is where b should have been before it: it stops there, and b does not wait for it. */
  @Test
  void whoHasGoneOnPastOneThatShouldGoFirstIsLeftOut() {
    releaseCells(2);
    assertFalse(adopter.adopt(plan, new BitSet()));
    assertFalse(a.drive.hasUnreleased());
    assertEquals(1 + 2 * 2, path(b).sectionCount()); // a turn on the spot and two cells
    assertTrue(path(b).dependencies().stream().allMatch(List::isEmpty));
  }

  /** Nobody waits in the plan's order for one that is not on its path. */
  @Test
  void nobodyWaitsForWhomThePlanDoesNotFit() {
    b.setMovable(false);
    assertFalse(adopter.adopt(plan, new BitSet()));
    assertEquals(2 * 3, path(a).sectionCount());
    assertTrue(path(a).dependencies().stream().allMatch(List::isEmpty));
  }

  @Test
  void whoDrivesAnotherPathByNowKeepsWhatIsReleasedOfThat() {
    a.drive.releaseNext(NOW);
    a.continueOn(ReservedPath.independent(a.releasedEnd(), List.of()));
    assertFalse(adopter.adopt(plan, new BitSet()));
    assertEquals(2, path(a).sectionCount()); // to the border, and on to where it is bound to go
  }
}
