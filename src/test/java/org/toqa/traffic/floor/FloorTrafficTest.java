package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.LacamJointPlanner;

class FloorTrafficTest {
  private static final Duration LIMIT = Duration.ofMinutes(5);

  @Test
  void aloneOnTheFloorARobotTakesTheSmoothWay() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(".....", ".....", "....."), 1);
    floor.put("a", new Cell(0, 2));
    floor.send("a", new Cell(4, 0));
    floor.drive(LIMIT);
    assertTrue(floor.isAt("a", new Cell(4, 0)));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void twoRobotsSwapPlacesInAnAisleWithOneBay(long seed) {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "#########", //
                "a.......b",
                "####.####"),
            seed);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(8, 1));
    floor.send("a", new Cell(8, 1));
    floor.send("b", new Cell(0, 1));
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  /** As with a load on it that stands out from it. */
  @Test
  void whoComesByKeepsOffARobotThatCoversMoreThanBefore() {
    String row = ".........";
    DrivenFloor floor =
        new DrivenFloor(DrivenFloor.draw(row, row, row, row, row, row, row, row), 1);
    floor.put("wide", new Cell(4, 5));
    floor.put("other", new Cell(0, 3));
    floor.send("other", new Cell(8, 3));
    floor.step();

    floor.body("wide").diameter = 1.2;
    floor.traffic.setDiameter("wide", 1.2);
    floor.drive(LIMIT);

    assertTrue(floor.isAt("other", new Cell(8, 3)));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void fourArrivalsAtACrossingAtOnce(long seed) {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "###.###", //
                "###.###", "###.###", ".......", "###.###", "###.###", "###.###"),
            seed);
    List<Cell> ends = List.of(new Cell(3, 0), new Cell(6, 3), new Cell(3, 6), new Cell(0, 3));
    for (int i = 0; i < 4; i++) {
      floor.put("r" + i, ends.get(i));
    }
    floor.send("r0", new Cell(3, 5)); // straight over, into the arm of r2
    floor.send("r1", new Cell(1, 3));
    floor.send("r2", new Cell(3, 1));
    floor.send("r3", new Cell(5, 3));
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  @Test
  void aRingWithOneFreePlaceTurns() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("...", ".#.", "..."), 1);
    List<Cell> ring = ring();
    for (int i = 0; i < 7; i++) {
      floor.put("r" + i, ring.get(i));
      floor.send("r" + i, ring.get((i + 2) % 8));
    }
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  @Test
  void inAFullRingEveryRobotSaysThatItWaits() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("...", ".#.", "..."), 1);
    List<Cell> ring = ring();
    for (int i = 0; i < 8; i++) {
      floor.put("r" + i, ring.get(i));
      floor.send("r" + i, ring.get((i + 1) % 8));
    }
    floor.drive(Duration.ofSeconds(20));
    Map<String, String> reasons = floor.reasons();
    assertEquals(8, reasons.size());
    reasons.forEach((robot, reason) -> assertTrue(reason.startsWith("Waiting"), robot + reason));
  }

  @Test
  void aRobotThatTakesItselfToBeBesideTheMapKeepsNobodyFromDriving() {
    FloorTraffic traffic =
        new FloorTraffic(
            DrivenFloor.draw(".....", "....."),
            new LacamJointPlanner(),
            () -> Deadline.in(Duration.ofSeconds(1), System::nanoTime));
    Instant now = Instant.EPOCH;
    traffic.reportStanding("astray", new Pose(-3, 0.2, 0), 0.255, now);
    traffic.reportStanding("b", new Pose(0.2, 0.2, 0), 0.255, now);
    traffic.setMovable("astray", true);
    traffic.setMovable("b", true);
    traffic.setGoal("astray", new Vec2(1, 0.6), now);
    traffic.setGoal("b", new Vec2(1.8, 0.2), now);
    List<DriveCommand> decided = new ArrayList<>();
    for (int tick = 1; tick < 10; tick++) {
      decided.addAll(traffic.decide(now.plusMillis(100L * tick)));
    }
    assertTrue(
        decided.stream().anyMatch(command -> command.robot().equals("b")), decided::toString);
  }

  @Test
  void aRobotThatWasStoppedAMillimetreInAWallDrivesAway() {
    FloorTraffic traffic =
        new FloorTraffic(
            DrivenFloor.draw("#####", "....."),
            new LacamJointPlanner(),
            () -> Deadline.in(Duration.ofSeconds(1), System::nanoTime));
    Instant now = Instant.EPOCH;
    // the wall begins at y = 0.4 m; 0.2735 + 0.255 / 2 = 0.401
    traffic.reportStanding("a", new Pose(0.2, 0.2735, 0), 0.255, now);
    traffic.setMovable("a", true);
    traffic.setGoal("a", new Vec2(1.8, 0.2), now);

    assertTrue(
        traffic.decide(now).stream().anyMatch(DriveCommand.Begin.class::isInstance),
        () -> String.valueOf(traffic.waitReason("a")));
  }

  /** Cells of 0.30 m: in the middle of one beside a wall there would be 0.0225 m. */
  @Test
  void atAGoalBesideAWallARobotStandsOffTheWall() {
    OccupancyGrid grid = new OccupancyGrid(6, 3, 0.3, Vec2.ZERO, new BitSet());
    DrivenFloor floor = new DrivenFloor(grid, 1);
    floor.put("a", new Cell(0, 1));
    floor.send("a", new Cell(3, 0));
    floor.drive(LIMIT);
    floor.step(); // it reports that it stands
    double wall = grid.height() * grid.resolution();
    double gap = wall - floor.body("a").pose.position().y() - DrivenFloor.DIAMETER / 2;
    assertEquals(0.0225 + 0.025, gap, 1e-6); // farther off it would not be at its goal
    assertTrue(floor.traffic.isAtGoal("a"));
  }

  /** The one before it waits for a third, and is lost then; there is another way round. */
  @ParameterizedTest
  @ValueSource(ints = {16, 20, 32})
  void whoStoppedBetweenTwoCellsBehindALostRobotTurnsBack(int ticks) {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "..........#", //
                ".########.#",
                ".########.#",
                ".########.#",
                "..........."),
            ticks);
    List<String> robots = List.of("b", "a", "c");
    List<Cell> goals = List.of(new Cell(9, 1), new Cell(9, 2), new Cell(10, 4));
    for (int i = 0; i < robots.size(); i++) {
      floor.put(robots.get(i), new Cell(i, 0));
      floor.send(robots.get(i), goals.get(i));
    }
    step(floor, ticks);
    floor.body("c").isStuck = true;
    step(floor, 80);
    floor.lose("a");
    floor.body("c").isStuck = false;
    floor.drive(LIMIT);
    assertTrue(floor.isArrived("b"), () -> floor.reasons().toString());
  }

  private static void step(DrivenFloor floor, int ticks) {
    for (int i = 0; i < ticks; i++) {
      floor.step();
    }
  }

  @Test
  void aRobotParkedInADoorwayStepsAside() {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "...#...", //
                "a..p..g", "...#..."),
            1);
    floor.put("parked", new Cell(3, 1));
    floor.put("a", new Cell(0, 1));
    floor.send("a", new Cell(6, 1));
    floor.drive(LIMIT);
    assertTrue(floor.isAt("a", new Cell(6, 1)), () -> floor.reasons().toString());
  }

  @Test
  void aGoalThatAnotherNeedsIsWaitedFor() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("......", "......"), 1);
    Cell shared = new Cell(5, 0);
    floor.put("a", new Cell(0, 0));
    floor.put("b", new Cell(0, 1));
    floor.send("a", shared);
    floor.send("b", shared);
    for (int i = 0; i < 600; i++) {
      floor.step();
    }
    List<String> there = new ArrayList<>();
    for (String r : List.of("a", "b")) {
      if (floor.isArrived(r)) {
        there.add(r);
      } else {
        assertTrue(floor.reason(r).startsWith("Waiting for"), floor.reason(r));
      }
    }
    assertEquals(1, there.size());
    floor.send(there.getFirst(), new Cell(0, 0));
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  @Test
  void aRobotWithoutAWaySaysSoAndDisturbsNobody() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("...#.", "...#.", "...#."), 1);
    floor.put("a", new Cell(0, 0));
    floor.put("b", new Cell(0, 1));
    floor.send("a", new Cell(4, 1));
    floor.send("b", new Cell(2, 2));
    floor.drive(Duration.ofSeconds(30));
    assertTrue(floor.isAt("b", new Cell(2, 2)));
    assertTrue(floor.reason("a").startsWith("Waiting"), floor.reason("a"));
  }

  @Test
  void aRobotThatStopsIsGoneRound() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(".......", ".......", "......."), 4);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(6, 1));
    floor.send("a", new Cell(6, 1));
    floor.send("b", new Cell(0, 1));
    for (int i = 0; i < 40; i++) {
      floor.step();
    }
    floor.body("a").isStuck = true;
    for (int i = 0; i < 1500 && !floor.isArrived("b"); i++) {
      floor.step();
    }
    assertTrue(floor.isArrived("b"), () -> floor.reasons().toString());
    floor.body("a").isStuck = false;
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  /** As where a person carries it: who was to drive there stops, and both are planned anew. */
  @Test
  void aRobotThatIsPutOntoTheWayOfAnotherOneStopsIt() {
    String row = "...........";
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(row, row, row), 4);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(5, 2));
    floor.send("a", new Cell(10, 1));
    for (int i = 0; i < 20; i++) {
      floor.step();
    }
    assertEquals(0, floor.cutOffs());

    floor.carry("b", new Cell(3, 1));
    floor.send("b", new Cell(0, 1));

    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
    assertEquals(1, floor.cutOffs());
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 15, 25, 40, 60, 80, 100, 120, 150, 180})
  void aRobotThatGivesUpItsWayIsNotWaitedForForEver(int steps) {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "#########", //
                "a.......b",
                "##.###.##"),
            1);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(8, 1));
    floor.send("a", new Cell(8, 1));
    floor.send("b", new Cell(0, 1));
    for (int i = 0; i < steps; i++) {
      floor.step();
    }

    floor.giveUp("a");

    floor.drive(LIMIT);
    assertTrue(floor.isArrived("b"), () -> floor.reasons().toString());
  }

  @Test
  void aRobotThatCannotBeToldAnythingIsGoneRound() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(".......", ".......", "......."), 4);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(6, 1));
    floor.send("a", new Cell(6, 1));
    floor.send("b", new Cell(0, 1));
    for (int i = 0; i < 40; i++) {
      floor.step();
    }

    floor.traffic.setMovable("a", false);

    for (int i = 0; i < 1500 && !floor.isArrived("b"); i++) {
      floor.step();
    }
    assertTrue(floor.isArrived("b"), () -> floor.reasons().toString());
  }

  @Test
  void robotsOfDifferentSizeShareAFloor() {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                ".........", //
                ".........",
                ".........",
                ".........",
                "........."),
            2);
    floor.put("big", new Cell(1, 2), 0.55);
    floor.put("a", new Cell(8, 2));
    floor.put("b", new Cell(5, 0));
    floor.send("big", new Cell(7, 2));
    floor.send("a", new Cell(0, 2));
    floor.send("b", new Cell(5, 4));
    floor.drive(LIMIT);
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  /** However much else the machine has to do: what planning may take is counted, not measured. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2})
  void theSameSeedIsTheSameRun(long seed) {
    assertEquals(crowdedRun(seed), crowdedRun(seed));
  }

  /** Where each of eight robots is at every step, while the best plan is looked for in vain. */
  private static List<String> crowdedRun(long seed) {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("....", "....", "...."), seed);
    for (int i = 0; i < 8; i++) {
      floor.put("r" + i, new Cell(i % 4, i / 4));
      floor.send("r" + i, new Cell(3 - i % 4, 2 - i / 4));
    }
    List<String> run = new ArrayList<>();
    for (int i = 0; i < 3000 && !floor.areAllArrived(); i++) {
      floor.step();
      floor.bodies.forEach((name, body) -> run.add(name + body.pose));
    }
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
    return run;
  }

  private static List<Cell> ring() {
    return List.of(
        new Cell(0, 0),
        new Cell(1, 0),
        new Cell(2, 0),
        new Cell(2, 1),
        new Cell(2, 2),
        new Cell(1, 2),
        new Cell(0, 2),
        new Cell(0, 1));
  }

  @Test
  void theRestOfAWayBeginsAtTheRobotAndNotBehindIt() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("....", "....", "...."), 1);
    floor.put("r", new Cell(0, 0));
    floor.send("r", new Cell(3, 2));
    while (!floor.isArrived("r")) {
      floor.step();
      List<Vec2> path = floor.traffic.remainingPath("r").points();
      for (int i = 2; i < path.size(); i++) {
        double along = path.get(i - 1).distanceTo(path.get(i));
        double round = path.get(i - 2).distanceTo(path.get(i));
        assertTrue(round >= along - 1e-6, () -> "back at " + path);
      }
    }
  }
}
