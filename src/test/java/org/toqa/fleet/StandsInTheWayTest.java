package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Who waits for a robot that does not go on by itself is told why not, and what a person can do.
 */
class StandsInTheWayTest extends HallFleetTest {
  private static final String AT_THE_DOOR =
      "Waiting for r2, which blocks the path at (4.50, 1.50) and cannot be moved; ";

  @BeforeEach
  void standInTheDoor() throws Exception {
    stage.add("r2", DOOR, null);
    stage.restart();
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
  }

  @Test
  void onHold() throws Exception {
    accepted(stage.fleet.holdRobot("r2", "Max"));
    assertTold(
        AT_THE_DOOR + "r2 is on hold: resume it",
        "Stands on hold at (4.50, 1.50) in the way of r1: resume it,"
            + " or carry it out of the way and set its position on its page");
  }

  @Test
  void outOfService() throws Exception {
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    assertTold(
        AT_THE_DOOR + "r2 is out of service: put it back in service, or carry it away",
        "Stands out of service at (4.50, 1.50) in the way of r1: put it back in"
            + " service; or switch it off and carry it away, and its place is free");
  }

  @Test
  void lost() throws Exception {
    scriptedRobot("r2").fallSilent();
    until(view -> robot(view, "r2").state() == RobotState.LOST);
    assertTold(
        AT_THE_DOOR
            + "r2 is not connected: switch it on, or carry it away and say that it does not stand"
            + " there any more",
        "Stands unconnected at (4.50, 1.50) in the way of r1: switch it on; or carry it"
            + " away, and then choose “Take out of service” or “Release its place” on its page");
  }

  @Test
  void failed() throws Exception {
    scriptedRobot("r2").breakDown("MOTOR");
    assertTold(
        AT_THE_DOOR + "r2 reports an error: look at it, then clear the error or carry it away",
        "Stands at (4.50, 1.50) in the way of r1 with an error: clear it; or"
            + " take it out of service on its page, switch it off and carry it away");
  }

  @Test
  void notLocalised() throws Exception {
    scriptedRobot("r2").forgetPlace();
    until(view -> robot(view, "r2").state() == RobotState.NOT_LOCALISED);
    assertTold(
        AT_THE_DOOR + "r2 does not know its position: set it on the robot’s page",
        "Stands at (4.50, 1.50) in the way of r1 and does"
            + " not know its position: set it on its page");
  }

  /**
   * @param sentence to who waits
   * @param alert on the robot that stands there, under what needs attention
   */
  private void assertTold(String sentence, String alert) throws Exception {
    long task = submit("West", "East");
    until(view -> waitReason(view, task).contains("; r2") && robot(view, "r2").alert() != null);
    assertEquals(alert, String.valueOf(robot(stage.fleet.snapshots().latest(), "r2").alert()));
    assertEquals(sentence, waitReason(stage.fleet.snapshots().latest(), task));
    assertEquals(
        sentence, String.valueOf(robot(stage.fleet.snapshots().latest(), "r1").work().doing()));
  }
}
