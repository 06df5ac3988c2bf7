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
    until(_ -> isOnTheOtherFloor("r2") && moved("r2").telemetry().lastSeen() != null);
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
    until(_ -> scriptedRobot("r1").position().equals(THERE));
    accepted(stage.fleet.putInService("r1", "Max"));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    scriptedRobot("r2").loseConnection();

    move("r2", DOOR);
    until(_ -> isOnTheOtherFloor("r2"));

    Pose pose = moved("r2").telemetry().pose();
    assertNotNull(pose);
    assertEquals(DOOR, pose.position());
    assertEquals(ScriptedRobot.FOOTPRINT, moved("r2").capabilities().footprint());
    accepted(stage.fleet.sendTo("r1", WEST));
    until(_ -> moved("r1").work().doing().english().startsWith("Waiting for r2"));
  }

  /** Nobody waits for the answer: it comes when the robot is told where it stands. */
  private void move(String robot, Vec2 place) {
    Pose pose = new Pose(place.x(), place.y(), 0);
    var _ = stage.fleet.moveRobot(robot, new RobotMove(ATTIC, pose), "Max");
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
