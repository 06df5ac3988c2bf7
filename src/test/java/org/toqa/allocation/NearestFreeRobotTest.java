package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class NearestFreeRobotTest {
  private final NearestFreeRobot allocator = new NearestFreeRobot();

  @Test
  void takesTheNearestOfThoseThatAreFreeAndStrongEnough() {
    Decision decision =
        allocator.allocate(
            3,
            new Vec2(0, 0),
            List.of(
                new Candidate("weak", 2, new Vec2(1, 0), true),
                new Candidate("busy", 5, new Vec2(1, 0), false),
                new Candidate("far", 5, new Vec2(9, 0), true),
                new Candidate("near", 5, new Vec2(3, 4), true)));
    // 3-4-5: near stands 5 m away
    assertEquals(
        new Decision.Assigned(List.of("near"), "the nearest free robot, 5.0 m from the load"),
        decision);
  }

  @Test
  void saysWhatATaskWaitsFor() {
    Vec2 object = new Vec2(0, 0);
    assertEquals("No robot has been added yet.", allocator.allocate(1, object, List.of()).why());
    List<Candidate> busy = List.of(new Candidate("r1", 5, object, false));
    assertEquals(
        "The only robot that can carry it is not free.", allocator.allocate(1, object, busy).why());
    assertEquals(
        "No robot can carry 7.5 kg: the strongest carries 5 kg.",
        allocator.allocate(7.5, object, busy).why());
  }
}
