package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskState;

/** What a driving robot is told and refused, and how idle ones get home. */
class FleetDrivingTest extends HallFleetTest {
  @Test
  void aRobotThatDoesNotGetOnIsToldUntilItDoes() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    scriptedRobot("r1").setStuck(true);
    until(view -> !view.floors().getFirst().standstills().isEmpty());
    FloorView.StandstillView standstill =
        stage.fleet.snapshots().latest().floors().getFirst().standstills().getFirst();
    scriptedRobot("r1").setStuck(false);
    until(view -> view.floors().getFirst().standstills().isEmpty());

    assertEquals(List.of("r1"), standstill.robots());
    untilHistory("traffic.resolved", "The standstill of r1 is over.");
    untilHistory("traffic.standstill", standstill.text().english());
    until(view -> task(view, task).state() == TaskState.DONE);
    assertTrue(
        stage.store.history(task).stream().anyMatch(e -> e.kind().equals("traffic.standstill")));
  }

  @Test
  void aChangeThatCrossesTheEndOfADriveIsNoTrouble() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    scriptedRobot("r1").endBeforeNextChange();
    until(
        view -> {
          String doing = String.valueOf(robot(view, "r1").work().doing());
          assertFalse(doing.contains("refused"), doing);
          return !scriptedRobot("r1").isAwaitingChange()
              && task(view, task).state() == TaskState.DONE;
        });
  }

  @Test
  void aDrivingRobotIsNotToldWhereItIs() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    Answer<RobotView> answer =
        stage.fleet.locateRobot("r1", new Pose(1.5, 1.5, 0), "Max").toCompletableFuture().get();

    assertInstanceOf(Answer.Rejected.class, answer);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aRobotIsToldThatTheEndOfItsTaskIsKept() throws Exception {
    long task = submit("West", "East");

    until(view -> task(view, task).state() == TaskState.DONE);

    until(view -> !scriptedRobot("r1").hasUnacknowledgedEnd());
  }

  @Test
  void anIdleRobotAwayFromItsParkingPointGoesHome() throws Exception {
    reopenWith("r2", new Vec2(12.5, 2.5), "P2");

    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    until(view -> scriptedRobot("r2").position().distanceTo(EAST) < 1e-6);
  }

  @Test
  void aPersonSendsAnIdleRobotHomeAndNoOther() throws Exception {
    reopenWith("r2", new Vec2(12.5, 2.5), "P2");
    reopenWith("r3", DOOR, null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));

    assertEquals(Phase.NONE, accepted(stage.fleet.sendHome("r2", "Max")).work().phase());
    assertInstanceOf(Answer.Conflict.class, answer(stage.fleet.sendHome("r3", "Max")));
    assertInstanceOf(Answer.Unknown.class, answer(stage.fleet.sendHome("r9", "Max")));

    until(view -> scriptedRobot("r2").position().distanceTo(EAST) < 1e-6);
    assertEquals(List.of("Max sent r2 home"), history("robot.sent-home"));
  }
}
