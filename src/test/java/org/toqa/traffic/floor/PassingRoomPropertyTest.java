package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.testbed.Cases;

/** Who has room beside its path may be anywhere in it, and no two bodies nor walls are touched. */
class PassingRoomPropertyTest {
  private final Cases rooms = new Cases("rooms beside paths");

  @Property(tries = 20)
  void robotsAnywhereInTheirRoomsTouchNobodyAndAllArrive(@ForAll long seed) {
    SplittableRandom chance = new SplittableRandom(seed);
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw(PassingRoomTest.HALL), seed);
    for (int i = 0; i < 4; i++) {
      floor.put("r" + i, new Cell(1 + 4 * i, 1 + chance.nextInt(5)));
    }
    for (int i = 0; i < 4; i++) {
      floor.send("r" + i, new Cell(16 - 4 * i, 1 + i));
    }
    for (int step = 0; step < 1200 && !floor.areAllArrived(); step++) {
      floor.step();
      String robot = "r" + chance.nextInt(4);
      DrivenBody body = floor.body(robot);
      if (body.trajectory != null && !floor.traffic.hasRoom(robot)) {
        Vec2 seen =
            body.pose
                .compose(new Pose(chance.nextDouble(0.4, 1), chance.nextDouble(-0.1, 0.1), 0))
                .position();
        var _ = rooms.count(floor.traffic.lendRoom(robot, List.of(seen), floor.now));
      }
    }
    floor.drive(Duration.ofMinutes(5));
    assertTrue(floor.areAllArrived(), floor.reasons().toString());
  }

  @AfterProperty
  void someWereLent() {
    rooms.assertPossible(0.005);
  }
}
