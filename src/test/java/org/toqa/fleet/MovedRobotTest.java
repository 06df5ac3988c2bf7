package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.wording.Phrase;

/** Robots that were carried to another floor. */
class MovedRobotTest extends HallFleetTest {
  private static final String ATTIC = "attic";
  private static final Vec2 THERE = new Vec2(6.5, 0.5);

  @BeforeEach
  void addAttic() throws Exception {
    stage.addFloor(new FloorMap(ATTIC, GRID, List.of(), List.of(), List.of()));
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
  }

  @Test
  void whomAPersonHasPutOnHoldStaysSoOnTheOtherFloor() throws Exception {
    accepted(stage.fleet.holdRobot("r2", "Max"));
    until(_ -> scriptedRobot("r2").isHeld());
    accepted(stage.fleet.takeOutOfService("r2", "Max"));

    move("r2", THERE);
    until(_ -> moved("r2").telemetry().lastSeen() != null);
    accepted(stage.fleet.putInService("r2", "Max"));
    until(_ -> moved("r2").state() == RobotState.HOLDING);
    stage.pass(Duration.ofSeconds(2));

    assertTrue(scriptedRobot("r2").isHeld());
    assertTrue(scriptedRobot("r2").obeyed().stream().noneMatch(Resume.class::isInstance));
    assertEquals(Phrase.HELD_BY_A_PERSON, moved("r2").work().doing().phrase());
    accepted(stage.fleet.resumeRobot("r2", "Max"));
    until(_ -> !scriptedRobot("r2").isHeld());
  }

  @Test
  void whoIsNotHeardHasItsPlaceOnTheOtherFloor() throws Exception {
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    move("r1", THERE);
    accepted(stage.fleet.putInService("r1", "Max"));
    until(_ -> moved("r1").state() == RobotState.IDLE);
    assertEquals(THERE, scriptedRobot("r1").position());
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    scriptedRobot("r2").loseConnection();

    move("r2", DOOR);

    assertEquals(DOOR, place());
    assertEquals(ScriptedRobot.FOOTPRINT, moved("r2").capabilities().footprint());
    accepted(stage.fleet.sendTo("r1", WEST));
    until(_ -> moved("r1").work().doing().english().startsWith("Waiting for r2"));
  }

  /** Its link was away while it was carried: it takes the old floor for the place where it is. */
  @Test
  void whatItSaysInTheFrameOfTheOldFloorIsNotBelieved() throws Exception {
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    scriptedRobot("r2").loseConnection();
    until(view -> robot(view, "r2").unreachable() != null);
    move("r2", DOOR);
    scriptedRobot("r2").refuse(Locate.class::isInstance);

    scriptedRobot("r2").speakAgain();
    until(_ -> moved("r2").telemetry().lastSeen() != null);
    accepted(stage.fleet.putInService("r2", "Max"));
    stage.pass(Duration.ofSeconds(5));

    assertNotLocated();
    stage.restart();
    until(_ -> isOnTheOtherFloor("r2") && moved("r2").state() == RobotState.NOT_LOCALISED);
    stage.pass(Duration.ofSeconds(30));
    assertNotLocated();
    scriptedRobot("r2").refuse(_ -> false);
    until(_ -> moved("r2").state() == RobotState.IDLE);
    assertEquals(DOOR, place());
    assertEquals(DOOR, scriptedRobot("r2").position());
    until(_ -> stage.store.storedRobots().stream().noneMatch(StoredRobot::carried));
  }

  private void assertNotLocated() {
    assertEquals(RobotState.NOT_LOCALISED, moved("r2").state());
    assertEquals(DOOR, place());
    assertEquals(EAST, scriptedRobot("r2").position());
    LastPlace stored = stage.store.storedRobots().getLast().place();
    assertNotNull(stored);
    assertEquals(DOOR, stored.pose().position());
  }

  private void move(String robot, Vec2 place) throws Exception {
    Pose pose = new Pose(place.x(), place.y(), 0);
    accepted(stage.fleet.moveRobot(robot, new RobotMove(ATTIC, pose), "Max"));
  }

  /** Of r2, as the server has it. */
  private Vec2 place() {
    Pose pose = moved("r2").telemetry().pose();
    assertNotNull(pose);
    return pose.position();
  }

  private boolean isOnTheOtherFloor(String robot) {
    return attic().robots().stream().anyMatch(r -> r.name().equals(robot));
  }

  private RobotView moved(String robot) {
    return robot(attic(), robot);
  }

  private FleetSnapshot attic() {
    return stage.fleet.snapshots(ATTIC).orElseThrow().latest();
  }
}
