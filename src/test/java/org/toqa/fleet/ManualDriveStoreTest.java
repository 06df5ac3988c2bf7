package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.link.message.ServerMessage.Drive;

/** A person drives a robot by hand while the store takes its time. */
class ManualDriveStoreTest extends HallFleetTest {
  @Test
  void aStepThatIsStoredWhenTheHandHasGoneDoesNotMoveTheRobot() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    stage.stopStoreFor(agent -> agent.startsWith("floor"));
    ManualAnswer answer = order(null, 1);
    assertNull(answer.refusal());
    stage.pass(Duration.ofSeconds(6)); // the network is cut

    stage.startStore();
    stage.pass(Duration.ofSeconds(2));

    assertEquals(0, drives());
    assertEquals(WEST, scriptedRobot("r1").position());

    assertEquals(answer.lease(), order(answer.lease(), 2).lease());
    stage.pass(Duration.ofSeconds(1));
    assertEquals(1, drives(), "who is back drives on");
    assertTrue(scriptedRobot("r1").position().x() > WEST.x());
  }

  private ManualAnswer order(@Nullable UUID lease, long number) throws Exception {
    return accepted(stage.fleet.driveByHand("r1", new ManualOrder(lease, number, 0.12, 0), "Ana"));
  }

  private long drives() {
    return scriptedRobot("r1").obeyed().stream().filter(Drive.class::isInstance).count();
  }
}
