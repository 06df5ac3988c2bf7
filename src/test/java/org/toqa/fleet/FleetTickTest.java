package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** A server that is held up for a while. */
class FleetTickTest extends HallFleetTest {
  @Test
  void robotsThatSpokeWhileTheServerWasHeldUpAreNotLost() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);

    // what it answers to the pings that come now is on its way for a second
    stage.holdUp(Duration.ofSeconds(10), scriptedRobot("r1")::fallSilent);
    stage.pass(Duration.ofSeconds(1));

    assertEquals(RobotState.IDLE, robot(stage.fleet.snapshots().latest(), "r1").state());
    until(view -> robot(view, "r1").state() == RobotState.LOST);
  }
}
