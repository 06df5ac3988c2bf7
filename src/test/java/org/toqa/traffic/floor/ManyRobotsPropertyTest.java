package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.testbed.Cases;

/** So many robots that only their next steps are planned together. */
@Tag("full")
class ManyRobotsPropertyTest {
  private final Cases floors = new Cases("generated floors");

  /** In a hall with pillars, on cells that leave room between robots, or a cell between them. */
  @Property(tries = 3, seed = "20261124")
  void inHallsEveryRobotArrivesAndNothingTouches(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = hall(random, random.nextBoolean() ? 0.4 : 0.5);
    List<Cell> free = FloorTrafficPropertyTest.largestPart(grid);
    int robots = Math.min(12 + random.nextInt(9), free.size() / 6);
    floors.count(robots >= 12);
    Collections.shuffle(free, random);
    DrivenFloor floor = new DrivenFloor(grid, seed);
    for (int i = 0; i < robots; i++) {
      floor.put("r" + i, free.get(i));
    }
    for (int round = 0; round < 3; round++) {
      List<Cell> goals = new ArrayList<>(free);
      Collections.shuffle(goals, random);
      for (int i = 0; i < robots; i++) {
        floor.send("r" + i, random.nextInt(8) == 0 ? null : goals.get(i));
      }
      floor.drive(Duration.ofMinutes(20));
      assertTrue(
          floor.areAllArrived(),
          () ->
              floor.reasons()
                  + " on\n"
                  + String.join("\n", FloorTrafficPropertyTest.picture(grid)));
    }
  }

  static OccupancyGrid hall(Random random, double cell) {
    int width = 14 + random.nextInt(6);
    int height = 10 + random.nextInt(6);
    BitSet pillars = new BitSet();
    for (int i = 0; i < width * height; i++) {
      pillars.set(i, random.nextInt(8) == 0);
    }
    return new OccupancyGrid(width, height, cell, Vec2.ZERO, pillars);
  }

  @AfterProperty
  void floorsHadRoomForRobots() {
    floors.assertPossible(0.9);
  }
}
