package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.mission.TaskState;

/** A robot that sees something small on its path is lent room beside that. */
class FleetRoomTest extends HallFleetTest {
  /** In the east room, on the path of the task. */
  private static final Vec2 THING = new Vec2(9.5, 1.5);

  private long task;

  /** It stands on its path, a little before the thing. */
  private void driveUpToTheThing() throws Exception {
    task = submit(new Where.Point(new Vec2(5.5, 1.5)), new Where.Point(new Vec2(13.5, 1.5)));
    until(
        view ->
            task(view, task).state() == TaskState.CARRYING
                && scriptedRobot("r1").isDriving()
                && scriptedRobot("r1").position().x() > 7.4);
    scriptedRobot("r1").setStuck(true);
    assertTrue(scriptedRobot("r1").position().x() < THING.x(), "it is past it");
  }

  @Test
  void roomIsReleasedBesideStoredAndLentUntilItIsGivenBack() throws Exception {
    driveUpToTheThing();

    scriptedRobot("r1").wantRoom(THING);

    until(_ -> rooms().size() == 1);
    Room lent = rooms().getFirst();
    assertTrue(lent.left() + lent.right() > 0.2 && lent.left() * lent.right() == 0, lent + "");
    Command before = scriptedRobot("r1").obeyed().reversed().stream().skip(1).findFirst().get();
    int released = before instanceof Release release ? release.released() : lent.to();
    assertTrue(lent.to() <= released, lent + " after " + before);
    assertEquals(Math.max(lent.left(), lent.right()), storedRoom());

    scriptedRobot("r1").returnRoom();
    until(_ -> storedRoom() == 0);
    scriptedRobot("r1").setStuck(false);
    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(1, rooms().size());
  }

  @Test
  void whatItDoesNotTakeIsNotKeptForIt() throws Exception {
    driveUpToTheThing();
    scriptedRobot("r1").refuseRoom();

    scriptedRobot("r1").wantRoom(THING);
    until(_ -> scriptedRobot("r1").hasRefusedRoom());
    scriptedRobot("r1").returnRoom();

    until(_ -> storedRoom() == 0);
    scriptedRobot("r1").setStuck(false);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aServerThatStartsAnewKeepsTheRoomUntilItIsGivenBack() throws Exception {
    driveUpToTheThing();
    scriptedRobot("r1").wantRoom(THING);
    until(_ -> rooms().size() == 1);

    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.DRIVING);
    stage.pass(Duration.ofSeconds(3));
    assertTrue(storedRoom() > 0);

    scriptedRobot("r1").returnRoom();
    until(_ -> storedRoom() == 0);
    scriptedRobot("r1").setStuck(false);
    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(1, rooms().size());
  }

  @Test
  void whoIsOnHoldIsLentNone() throws Exception {
    driveUpToTheThing();
    accepted(stage.fleet.holdRobot("r1", "Max"));
    until(_ -> scriptedRobot("r1").isHeld());
    scriptedRobot("r1").wantRoom(THING);
    stage.pass(Duration.ofSeconds(3));
    assertEquals(List.of(), rooms());
  }

  private List<Room> rooms() {
    return scriptedRobot("r1").obeyed().stream()
        .filter(Room.class::isInstance)
        .map(Room.class::cast)
        .toList();
  }

  /** Metres, on the wider side; 0: none is stored. */
  private double storedRoom() {
    return stage
        .database
        .jdbi()
        .withHandle(
            h ->
                h.createQuery("select greatest(room_left, room_right) from drives")
                    .mapTo(Double.class)
                    .list())
        .stream()
        .filter(Objects::nonNull)
        .mapToDouble(Double::doubleValue)
        .max()
        .orElse(0);
  }
}
