package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.testbed.Cases;

/**
 * Plans that are ready up to two seconds after the floor was pictured, while robots drive on: all
 * arrive, and {@link DrivenFloor} sees to it that none ever touch.
 */
@Tag("full")
class LatePlanPropertyTest {
  private static final Duration MOST_PLANNING = Duration.ofSeconds(2);

  private final Cases floors = new Cases("generated floors");

  /** Few robots, planned whole, in one-cell aisles. */
  @Property(tries = 10, seed = "20261125")
  void inAislesEveryRobotArrives(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = FloorTrafficPropertyTest.aisles(random);
    List<Cell> free = FloorTrafficPropertyTest.largestPart(grid);
    int robots = Math.min(2 + random.nextInt(7), free.size() / 4);
    floors.count(robots >= 2);
    if (robots >= 2) {
      driveToThreeGoals(new DrivenFloor(grid, seed, MOST_PLANNING), free, robots, random);
    }
  }

  /** Many, whose next steps are planned, in a hall with pillars. */
  @Property(tries = 2, seed = "20261125")
  void inHallsEveryRobotArrives(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = ManyRobotsPropertyTest.hall(random, random.nextBoolean() ? 0.4 : 0.5);
    List<Cell> free = FloorTrafficPropertyTest.largestPart(grid);
    int robots = Math.min(12 + random.nextInt(9), free.size() / 6);
    floors.count(robots >= 12);
    driveToThreeGoals(new DrivenFloor(grid, seed, MOST_PLANNING), free, robots, random);
  }

  /** Goals are given up, robots stop, and some are lost, also while they are planned. */
  @Property(tries = 5, seed = "20261125")
  void troublesWhileAPlanIsMadeDisturbNothing(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = FloorTrafficPropertyTest.aisles(random);
    List<Cell> free = FloorTrafficPropertyTest.largestPart(grid);
    int robots = Math.min(2 + random.nextInt(6), free.size() / 4);
    floors.count(robots >= 2);
    if (robots < 2) {
      return;
    }
    Collections.shuffle(free, random);
    DrivenFloor floor = new DrivenFloor(grid, seed, MOST_PLANNING);
    for (int i = 0; i < robots; i++) {
      floor.put("r" + i, free.get(i));
      floor.send("r" + i, free.get(free.size() - 1 - i));
    }
    for (int step = 0; step < 1500; step++) {
      disturb(floor, "r" + random.nextInt(robots), free, random);
      floor.step();
    }
    for (int i = 0; i < robots; i++) {
      floor.body("r" + i).isStuck = false;
      floor.find("r" + i);
      floor.giveUp("r" + i);
    }
    floor.step();
    for (int i = 0; i < robots; i++) {
      floor.send("r" + i, free.get(i));
    }
    floor.drive(Duration.ofMinutes(20));
    assertAllArrived(floor);
  }

  private static void disturb(DrivenFloor floor, String robot, List<Cell> free, Random random) {
    if (random.nextInt(100) == 0) {
      floor.giveUp(robot);
    } else if (random.nextInt(20) == 0 && floor.isArrived(robot)) {
      floor.send(robot, free.get(random.nextInt(free.size())));
    }
    if (random.nextInt(60) == 0) {
      floor.body(robot).isStuck ^= true;
    }
    if (random.nextInt(200) == 0) {
      floor.lose(robot);
    }
    if (random.nextInt(100) == 0) {
      floor.find(robot);
    }
  }

  private static void driveToThreeGoals(
      DrivenFloor floor, List<Cell> free, int robots, Random random) {
    Collections.shuffle(free, random);
    for (int i = 0; i < robots; i++) {
      floor.put("r" + i, free.get(i));
    }
    for (int round = 0; round < 3; round++) {
      Collections.shuffle(free, random);
      for (int i = 0; i < robots; i++) {
        floor.send("r" + i, random.nextInt(6) == 0 ? null : free.get(i));
      }
      floor.drive(Duration.ofMinutes(20));
      assertAllArrived(floor);
    }
  }

  private static void assertAllArrived(DrivenFloor floor) {
    assertTrue(
        floor.areAllArrived(),
        () ->
            floor.reasons()
                + " on\n"
                + String.join("\n", FloorTrafficPropertyTest.picture(floor.grid)));
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.8);
  }
}
