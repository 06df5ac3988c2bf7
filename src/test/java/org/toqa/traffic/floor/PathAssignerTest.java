package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Margins;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.mapf.LacamJointPlanner;

/** A floor whose plans are made when the test says so, and what happens to it meanwhile. */
class PathAssignerTest {
  private static final double DIAMETER = 0.255;

  private final OccupancyGrid floor =
      DrivenFloor.draw(
          "............", //
          "............",
          "............");
  private final Queue<Runnable> plans = new ArrayDeque<>();
  private final FloorTraffic traffic = traffic(new LacamJointPlanner());
  private Instant now = Instant.EPOCH;

  private FloorTraffic traffic(JointPlanner planner) {
    return new FloorTraffic(
        floor,
        Margins.USUAL,
        Moves.HEADING,
        planner,
        FloorTraffic::rollingPlanner,
        Deadline::none,
        plans::add);
  }

  private void put(FloorTraffic on, String robot, Cell cell) {
    Vec2 at = floor.centre(cell);
    on.reportStanding(robot, new Pose(at.x(), at.y(), 0), DIAMETER, now);
    on.setMovable(robot, true);
  }

  private void put(String robot, Cell cell) {
    put(traffic, robot, cell);
  }

  private void send(String robot, Cell goal) {
    traffic.setGoal(robot, floor.centre(goal), now);
  }

  private List<DriveCommand> tick() {
    now = now.plusMillis(100);
    return traffic.decide(now);
  }

  /** The plan that is asked for is made. */
  private void makePlan() {
    plans.remove().run();
  }

  @Test
  void aPlanIsAdoptedAtTheTickAfterItIsMade() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    assertEquals(List.of(), tick());
    assertEquals(List.of(), tick());
    assertEquals(1, plans.size(), "one plan is made at a time");
    makePlan();
    assertEquals("a", tick().getFirst().robot());
  }

  /** It drives from end to end while the plan that others wait for never comes. */
  @Test
  void aPlanThatNeverComesDelaysNoRelease() {
    put("a", new Cell(0, 0));
    send("a", new Cell(11, 0));
    tick();
    makePlan();
    DriveCommand.Begin begin = (DriveCommand.Begin) tick().getFirst();
    put("b", new Cell(3, 2));
    send("b", new Cell(8, 2));
    tick();
    assertEquals(1, plans.size(), "a plan for b is being made");
    Trajectory trajectory = begin.trajectory();
    int segments = trajectory.segments().size();
    int released = begin.released();
    assertTrue(released < segments);
    for (int completed = 1; completed < segments; completed++) {
      traffic.reportProgress("a", trajectory.poseAfter(completed), completed, now);
      for (DriveCommand command : tick()) {
        released = ((DriveCommand.Release) command).released();
      }
      assertTrue(released > completed, "it is stopped behind " + completed);
    }
    assertEquals(segments, released);
  }

  @Test
  void whoCanNoLongerMoveIsSentNowhere() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    traffic.setMovable("a", false);
    makePlan();
    assertEquals(List.of(), tick());
    assertFalse(traffic.remainingPath("a").points().size() > 1);
  }

  @Test
  void aPathToAGoalThatIsNoLongerWantedIsNotDriven() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    send("a", new Cell(0, 0));
    makePlan();
    assertEquals(List.of(), tick());
    makePlan();
    DriveCommand.Begin begin = (DriveCommand.Begin) tick().getFirst();
    assertEnd(new Cell(0, 0), begin);
  }

  @Test
  void aPathAtASpeedThatIsNoLongerAllowedIsNotDriven() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    traffic.setSpeeds("a", DriveSpeeds.DEFAULT.atMost(0.05, 1));
    makePlan();
    assertEquals(List.of(), tick());
  }

  @Test
  void aPathOverAnObstacleThatHasAppearedIsNotDriven() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    BitSet obstacle = new BitSet();
    obstacle.set(floor.index(new Cell(3, 1)));
    traffic.setObstacles(obstacle, Map.of());
    makePlan();
    assertEquals(List.of(), tick());
    makePlan();
    assertEnd(new Cell(5, 1), (DriveCommand.Begin) tick().getFirst());
  }

  @Test
  void whoHasAppearedInTheWayIsGoneRound() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    put("b", new Cell(3, 1));
    traffic.setMovable("b", false);
    makePlan();
    assertEquals(List.of(), tick());
    makePlan();
    DriveCommand.Begin begin = (DriveCommand.Begin) tick().getFirst();
    assertEnd(new Cell(5, 1), begin);
    Trajectory trajectory = begin.trajectory();
    Vec2 b = floor.centre(new Cell(3, 1));
    for (int i = 0; i <= trajectory.segments().size(); i++) {
      assertTrue(trajectory.poseAfter(i).position().distanceTo(b) > DIAMETER);
    }
  }

  @Test
  void whoWasPutElsewhereBeginsWhereItIs() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    put("a", new Cell(0, 2));
    makePlan();
    assertEquals(List.of(), tick());
    makePlan();
    DriveCommand.Begin begin = (DriveCommand.Begin) tick().getFirst();
    assertTrue(
        begin.trajectory().start().position().distanceTo(floor.centre(new Cell(0, 2))) < 1e-9);
  }

  @Test
  void whoIsGoneIsForgotten() {
    put("a", new Cell(0, 1));
    send("a", new Cell(5, 1));
    tick();
    traffic.removeRobot("a");
    makePlan();
    assertEquals(List.of(), tick());
  }

  /** The tick in which it is known fails; the floor goes on, and asks again. */
  @Test
  void aPlannerThatFailsIsAskedAgain() {
    List<RuntimeException> failures = new ArrayList<>(List.of(new IllegalStateException("once")));
    JointPlanner lacam = new LacamJointPlanner();
    FloorTraffic failing =
        traffic(
            (roads, spacing, starts, goals, deadline) -> {
              if (!failures.isEmpty()) {
                throw failures.removeFirst();
              }
              return lacam.plan(roads, spacing, starts, goals, deadline);
            });
    put(failing, "a", new Cell(0, 1));
    put(failing, "b", new Cell(5, 1));
    failing.setGoal("a", floor.centre(new Cell(5, 1)), now);
    failing.setGoal("b", floor.centre(new Cell(0, 1)), now);
    failing.decide(now);
    makePlan();
    assertThrows(IllegalStateException.class, () -> failing.decide(now));
    List<DriveCommand> told = new ArrayList<>();
    for (int i = 0; i < 100 && told.size() < 2; i++) {
      now = now.plus(Duration.ofMillis(100));
      told.addAll(failing.decide(now));
      if (!plans.isEmpty()) {
        makePlan();
      }
    }
    assertEquals(2, told.size());
  }

  private void assertEnd(Cell goal, DriveCommand.Begin begin) {
    Trajectory trajectory = begin.trajectory();
    Vec2 end = trajectory.poseAfter(trajectory.segments().size()).position();
    assertTrue(end.distanceTo(floor.centre(goal)) < 1e-6, () -> end + " is not in " + goal);
  }
}
