package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/** Robots that are taken out of service and put back, changed and removed. */
class FleetServiceTest extends HallFleetTest {
  @Test
  void aRobotOutOfServiceStopsAndGoesOnWhenItIsBackInService() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    until(view -> !scriptedRobot("r1").isDriving());
    Vec2 stopped = scriptedRobot("r1").position();
    until(view -> waitReason(view, task).equals("r1 is out of service: put it back in service"));
    stage.restart(); // and it survives a restart
    until(view -> !view.robots().isEmpty() && robot(view, "r1").telemetry().pose() != null);
    assertEquals(RobotState.OUT_OF_SERVICE, robot(stage.fleet.snapshots().latest(), "r1").state());
    assertEquals(
        "r1 is out of service: put it back in service",
        waitReason(stage.fleet.snapshots().latest(), task));
    assertEquals(stopped, scriptedRobot("r1").position());

    accepted(stage.fleet.putInService("r1", "Clara"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(0, scriptedRobot("r1").position().distanceTo(WEST), 1e-6);
    assertEquals(List.of("Clara put r1 back in service"), history("robot.in-service"));
    assertTrue(
        stage.store.history(task).stream()
            .anyMatch(e -> e.text().equals("Max took r1 out of service")));
  }

  @Test
  void aTaskSaysThatItsOnlyRobotIsOutOfServiceAndIsDoneWhenItIsBack() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    long task = submit("West", "East");
    until(view -> waitReason(view, task).equals("The only robot, r1, is out of service."));
    accepted(stage.fleet.putInService("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aRobotIsRemovedWhenItIsOutOfServiceAndComesBackWhenItIsAdded() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit("East", "West");
    until(view -> task(view, task).state() == TaskState.CARRYING);
    assertEquals(List.of("r2"), task(stage.fleet.snapshots().latest(), task).robots());
    assertInstanceOf(Answer.Conflict.class, answer(stage.fleet.removeRobot("r2", "Max")));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    assertInstanceOf(
        Answer.Conflict.class, answer(stage.fleet.removeRobot("r2", "Max")), "it has a task");
    accepted(stage.fleet.putInService("r2", "Max"));
    until(view -> task(view, task).state() == TaskState.DONE);
    until(view -> robot(view, "r2").work().task() == null);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));

    accepted(stage.fleet.removeRobot("r2", "Max"));

    assertEquals(1, stage.fleet.snapshots().latest().robots().size());
    assertEquals(List.of("Max removed r2"), history("robot.removed"));
    assertInstanceOf(Answer.Unknown.class, answer(stage.fleet.removeRobot("r2", "Max")));
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertEquals(1, stage.fleet.snapshots().latest().robots().size());
    RobotOrder again = new RobotOrder("r2", "127.0.0.1", 1, 5, "P2", null);
    accepted(stage.fleet.addRobot(again, "Max"));
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long next = submit("East", "West");
    until(view -> task(view, next).state() == TaskState.DONE);
    assertEquals(List.of("r2"), stage.store.task(task).orElseThrow().robots(), "it is remembered");
  }

  @Test
  void aRobotIsChangedAndStaysSo() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    assertInstanceOf(
        Answer.Rejected.class,
        answer(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 1, 9, "P1"), "Max")),
        "r1 parks there");
    assertInstanceOf(
        Answer.Rejected.class,
        answer(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 1, 9, "P9"), "Max")));
    assertEquals(
        new Answer.Rejected<>("gateway", Phrase.NO_SUCH_GATEWAY.with("dock")),
        answer(
            stage.fleet.changeRobot(
                "r2", new RobotChange("127.0.0.1", 1, 9, null, "dock"), "Max")));

    RobotView changed =
        accepted(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 2, 3, null), "Max"));

    assertEquals(3, changed.maxLoad());
    assertEquals(2, changed.record().port());
    assertNull(changed.record().parking());
    assertEquals(List.of("Max changed r2"), history("robot.changed"));
    stage.restart();
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    assertEquals(3, robot(stage.fleet.snapshots().latest(), "r2").maxLoad());
  }

  @Test
  void aRobotThatAnotherHasChangedSinceItWasSeenIsNotChanged() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    RobotChange seen = robot(stage.fleet.snapshots().latest(), "r1").record().toChange();
    RobotChange weaker = new RobotChange("127.0.0.1", 1, 3, "P1");
    accepted(stage.fleet.changeRobot("r1", weaker, seen, "Max"));

    assertInstanceOf(
        Answer.Outdated.class,
        answer(
            stage.fleet.changeRobot("r1", new RobotChange("127.0.0.1", 1, 5, null), seen, "Boss")));

    until(view -> robot(view, "r1").record().toChange().equals(weaker));
    assertEquals(weaker, stage.store.robots().getFirst().toChange());
    assertEquals(List.of("Max changed r1"), history("robot.changed"));
  }

  @Test
  void aRobotOutOfServiceGetsNoTask() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    long task = submit("West", "East"); // r1 is nearest

    until(view -> task(view, task).robots().equals(List.of("r2")));
  }

  @Test
  void whatIsSoAlreadyIsAcceptedAndNotToldAgain() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);

    assertEquals(RobotState.IDLE, accepted(stage.fleet.putInService("r1", "Max")).state());
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    assertEquals(List.of(), history("robot.in-service"));
    assertEquals(1, history("robot.out-of-service").size());
    assertInstanceOf(
        Answer.Unknown.class,
        stage.fleet.takeOutOfService("r9", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS));
  }

  @Test
  void whoStandsInTheWayAndMustBeCarriedAwayNeedsAttention() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    assertNull(robot(stage.fleet.snapshots().latest(), "r2").alert());

    long task = submit("West", "East");

    until(view -> robot(view, "r2").alert() != null);
    assertEquals(
        "Stands out of service at (4.50, 1.50) in the way of r1: put it back in service; or switch"
            + " it off and carry it away, and its place is free",
        String.valueOf(robot(stage.fleet.snapshots().latest(), "r2").alert()));
    accepted(stage.fleet.putInService("r2", "Max"));
    until(view -> task(view, task).state() == TaskState.DONE && robot(view, "r2").alert() == null);
  }

  @Test
  void noMoreIsAcceptedThanRobotsSayThatTheyCarry() throws Exception {
    accepted(
        stage.fleet.changeRobot(
            "r1", new RobotChange("127.0.0.1", 1, 50, "P1"), null, "Max")); // it says 5 kg
    until(view -> robot(view, "r1").state() == RobotState.IDLE && robot(view, "r1").maxLoad() < 50);

    Answer<TaskView> refused = answer(stage.fleet.submit(order(20), "Clara"));

    assertEquals("load", assertInstanceOf(Answer.Rejected.class, refused).field());
  }

  @Test
  void aRobotThatWasNeverConnectedMakesNoTaskPossible() throws Exception {
    stage.add("r2", EAST, "P2").fallSilent(); // 5 kg were entered for it
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);

    Answer<TaskView> refused = answer(stage.fleet.submit(orderForSeveral(8), "Clara"));

    assertEquals(
        "The robots cannot carry 8 kg: together they carry 5 kg."
            + " A robot counts once it has been connected. Split the load.",
        assertInstanceOf(Answer.Rejected.class, refused).sentence().english());
    scriptedRobot("r2").speakAgain();
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    accepted(stage.fleet.submit(orderForSeveral(8), "Clara"));
    scriptedRobot("r2").loseConnection();
    stage.restart(); // what it said is remembered
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.submit(orderForSeveral(8), "Clara"));
  }

  @Test
  void aRobotThatCannotBeReachedSaysWhy() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);

    scriptedRobot("r1").loseConnection();

    until(view -> robot(view, "r1").state() == RobotState.LOST);
    RobotView lost = robot(stage.fleet.snapshots().latest(), "r1");
    assertEquals("Lost: cut Its place stays reserved.", lost.work().doing().english());
    assertEquals("cut", String.valueOf(lost.unreachable()));
    scriptedRobot("r1").speakAgain();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertNull(robot(stage.fleet.snapshots().latest(), "r1").unreachable());
  }
}
