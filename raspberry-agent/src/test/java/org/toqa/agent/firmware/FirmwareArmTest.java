package org.toqa.agent.firmware;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmCommand;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
import org.toqa.geometry.Pose;

/** What is made of the statuses of a microcontroller's arm. */
class FirmwareArmTest {
  private static final JointLimits JOINT = new JointLimits(-2.5, 2.5, 1.5, 4);
  private static final JointAngles REST = new JointAngles(2, -2.4);
  private static final JointAngles PUSHED = new JointAngles(1.5, -2.4);
  private static final Arm ARM = new Arm(0.3, 0.25, new Pose(0, 0, 0), JOINT, JOINT, 2, REST);

  private final FirmwareArm arm = new FirmwareArm(ArmSettings.of(ARM), new Silence());

  private record Silence() implements FrameTransport {
    @Override
    public byte[] exchange(byte[] frame, long nanos) {
      return new byte[0];
    }

    @Override
    public void close() {
      // it has nothing
    }
  }

  private void update(ArmStatus.State state, JointAngles angles, JointAngles goal) {
    arm.update(
        new ArmStatus(state, false, angles, goal, 0, state == ArmStatus.State.STANDING ? 1 : 0));
    arm.exchange(new ArmCommand(REST, JointAngles.ZERO, false, REST, true), 0);
  }

  /** Whoever pushed it has gone. */
  @Test
  void stallIsOverWhenTheJointsStandWhereTheyShall() {
    update(ArmStatus.State.STANDING, REST, REST);
    update(ArmStatus.State.STALLED, PUSHED, REST);
    assertTrue(arm.reading().stalled());
    update(ArmStatus.State.STANDING, PUSHED, PUSHED);
    update(ArmStatus.State.STANDING, REST, REST);
    assertFalse(arm.reading().stalled());
  }
}
