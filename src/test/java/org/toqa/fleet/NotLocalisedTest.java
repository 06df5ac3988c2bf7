package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;

/**
 * Robots that do not know any more where they are, and say that they are at (0, 0), the lower left
 * corner of the hall.
 */
class NotLocalisedTest extends HallFleetTest {
  private static final double BODIES = 0.255; // metres from middle to middle where two touch

  @Test
  void whereItStandsStaysItsOwn() throws Exception {
    reopenWith("r2", DOOR, null);
    untilAllIdle();

    forgetPlace("r2");

    assertEquals(DOOR, place("r2"));
    assertEquals(
        "Does not know its position: set it on the robot’s page. Its place stays reserved.",
        doing("r2"));
    long task = submit("West", "East");
    until(
        view -> {
          assertApart("r1", "r2");
          return waitReason(view, task).startsWith("Waiting for r2");
        });
    scriptedRobot("r2").findPlace();
    untilDone(task);
  }

  @Test
  void whoIsWhereItSaysThatItIsGoesOn() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    untilAllIdle();
    scriptedRobot("r1").setStepsPerSegment(20);
    long task = submit("West", "East");
    until(view -> scriptedRobot("r1").isDriving());

    scriptedRobot("r2").forgetPlace(new Pose(0.5, 1.5, 0));

    untilDone(task);
    assertEquals(List.of(), history("traffic.cut-off"));
  }

  @Test
  void whatItHasOnBoardIsWhereItWasLastKnownToBe() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").breakDown("SWITCH");
    Vec2 there = scriptedRobot("r1").position();

    forgetPlace("r1");

    until(view -> task(view, task).needs() != null);
    TaskPlace load = task(stage.fleet.snapshots().latest(), task).loadAt();
    assertNotNull(load);
    assertEquals(there, load.position());
  }

  /** It was not heard while it drove on. */
  @Test
  void allThatItMayHaveDrivenUnheardStaysItsOwn() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    untilAllIdle();
    long first = submit("West", "East");
    untilCarryingOnTheWay(first);
    scriptedRobot("r1").loseServer();
    until(view -> robot(view, "r1").state() == RobotState.LOST);
    scriptedRobot("r1").findServer();

    forgetPlace("r1");

    Vec2 whereItIs = scriptedRobot("r1").position();
    assertTrue(whereItIs.distanceTo(place("r1")) > 1, "it has driven on");
    stage.restart();
    until(view -> view.robots().size() == 2 && robot(view, "r2").state() == RobotState.IDLE);
    long second = submit(IN_THE_MIDDLE, new Where.Point(whereItIs));
    until(
        view -> {
          assertApart("r1", "r2");
          return waitReason(view, second).startsWith("Waiting for r1");
        });
    scriptedRobot("r1").findPlace();
    until(
        view -> {
          assertApart("r1", "r2");
          return task(view, first).state() == TaskState.DONE
              && task(view, second).state() == TaskState.DONE;
        });
  }

  @Test
  void aServerThatStartsMeanwhileKnowsWhereItStands() throws Exception {
    reopenWith("r2", DOOR, null);
    untilAllIdle();
    forgetPlace("r2");

    stage.restart();

    until(view -> robot(view, "r2").state() == RobotState.NOT_LOCALISED);
    assertEquals(DOOR, place("r2"));
    long task = submit("West", "East");
    until(
        view -> {
          assertApart("r1", "r2");
          return waitReason(view, task).startsWith("Waiting for r2");
        });
    stage.restart();
    until(view -> robot(view, "r2").state() == RobotState.NOT_LOCALISED);
    assertEquals(DOOR, place("r2"));
  }

  @Test
  void itIsInNobodysWayWhenAPersonHasSaidWhereItIs() throws Exception {
    reopenWith("r2", DOOR, null);
    untilAllIdle();
    forgetPlace("r2");

    accepted(stage.fleet.locateRobot("r2", new Pose(14.5, 2.5, 0), "Max"));

    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    assertEquals(new Vec2(14.5, 2.5), place("r2"));
    untilDone(submit("West", "East"));
  }

  @Test
  void whoWasToDriveWhereAPersonHasSaidThatItIsStops() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    untilAllIdle();
    forgetPlace("r2");
    scriptedRobot("r1").setStepsPerSegment(20);
    submit("West", "East");
    until(view -> scriptedRobot("r1").isDriving());

    accepted(stage.fleet.locateRobot("r2", new Pose(0.5, 1.5, 0), "Max"));

    untilHistory(
        "traffic.cut-off", "r2 stands where r1 was to drive; r1 stops, and both are planned again");
  }

  @Test
  void whoseWheelsAreTurnedMeanwhileStaysWhereItWas() throws Exception {
    reopenWith("r2", DOOR, null);
    untilAllIdle();
    forgetPlace("r2");

    scriptedRobot("r2").shove(new Vec2(1, 0));
    stage.pass(Duration.ofSeconds(1));

    assertEquals(DOOR, place("r2"));
  }

  @Test
  void whoNeverKnewWhereItIsTakesNoPlace() throws Exception {
    ScriptedRobot robot = stage.add("r2", new Vec2(14.5, 0.5), null);
    robot.forgetPlace();

    stage.restart();

    until(view -> robot(view, "r2").state() == RobotState.NOT_LOCALISED);
    assertNull(robot(stage.fleet.snapshots().latest(), "r2").telemetry().pose());
    assertEquals(
        "Does not know its position: set it on the robot’s page. No place is reserved for it.",
        doing("r2"));
    long task = submit("West", "East");
    untilDone(task);
    robot.findPlace();
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    assertEquals(new Vec2(14.5, 0.5), place("r2"));
  }

  @Test
  void aDriveOfOneThatDoesNotKnowWhereItIsIsEnded() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    scriptedRobot("r1").setStepsPerSegment(100);
    Vec2 there = place("r1");

    scriptedRobot("r1").driveBlindly(new Pose(0, 0, 0));

    until(view -> !scriptedRobot("r1").isDriving());
    assertEquals(there, place("r1"));
  }

  /** The load lies between the two, where nobody stands. */
  @Test
  void aGroupWhoseLeaderForgetsItsPlaceKeepsThatOfItsLoad() throws Exception {
    stage.add("r2", new Vec2(8.5, 0.5), null);
    reopenWith("r3", new Vec2(14.5, 0.5), null);
    untilAllIdle();
    accepted(stage.fleet.takeOutOfService("r3", "Max"));
    long task = submit(orderForSeveral(8));
    until(view -> task(view, task).state() == TaskState.CARRYING && isLedOnItsWay(view, task));
    List<String> group = task(stage.fleet.snapshots().latest(), task).robots();
    String leader = group.getFirst();
    accepted(stage.fleet.holdRobot(leader, "Max"));
    scriptedRobot(leader).stopItself("STOP_SWITCH"); // then it has no path any more
    until(view -> robot(view, leader).state() == RobotState.ERROR);
    accepted(stage.fleet.clearStops(leader, Set.of("STOP_SWITCH"), "Max"));
    until(view -> robot(view, leader).state() == RobotState.HOLDING);
    Vec2 one = scriptedRobot(leader).position();
    Vec2 other = scriptedRobot(group.getLast()).position();
    Vec2 load = new Vec2((one.x() + other.x()) / 2, (one.y() + other.y()) / 2);

    forgetPlace(leader);

    assertEquals(one, place(leader));
    accepted(stage.fleet.putInService("r3", "Max"));
    accepted(stage.fleet.sendTo("r3", load));
    until(view -> doing("r3").startsWith("Waiting for " + leader));
  }

  private boolean isLedOnItsWay(FleetSnapshot view, long task) {
    Vec2 leader = scriptedRobot(task(view, task).robots().getFirst()).position();
    return leader.x() > 8;
  }

  private void untilAllIdle() throws InterruptedException {
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
  }

  private void untilDone(long task) throws InterruptedException {
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  /** Until the server has heard of it. */
  private void forgetPlace(String robot) throws InterruptedException {
    scriptedRobot(robot).forgetPlace();
    until(view -> robot(view, robot).state() == RobotState.NOT_LOCALISED);
  }

  private String doing(String robot) {
    return robot(stage.fleet.snapshots().latest(), robot).work().doing().english();
  }

  /** As the server has it. */
  private Vec2 place(String robot) {
    Pose pose = robot(stage.fleet.snapshots().latest(), robot).telemetry().pose();
    assertNotNull(pose);
    return pose.position();
  }

  private void assertApart(String one, String other) {
    double distance = scriptedRobot(one).position().distanceTo(scriptedRobot(other).position());
    assertTrue(distance > BODIES, one + " and " + other + " are " + distance + " m apart");
  }
}
