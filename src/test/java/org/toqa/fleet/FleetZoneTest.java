package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Margins;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.mission.TaskState;
import org.toqa.motion.FreeZone;

/** A free zone of the floor is lent as a whole to a robot that says that it finds its own way. */
@Timeout(60)
class FleetZoneTest {
  private static final Area ZONE = new Area(new Vec2(5, 0), 6, 3);

  private final FleetStage stage =
      new FleetStage(
          new FloorMap(
              "hall", HallFleetTest.FLOOR.drawing().withFreeZones(List.of(ZONE)), Margins.USUAL));

  @AfterEach
  void stop() {
    stage.close();
  }

  private long drive(boolean findsOwnWay) throws Exception {
    stage.add("r1", new Vec2(0.5, 0.5), "P1").setFreeZones(findsOwnWay);
    stage.restart();
    TaskOrder order =
        new TaskOrder(
            "box",
            1,
            new Where.Point(new Vec2(2.5, 1.5)),
            new Where.Point(new Vec2(13.5, 1.5)),
            null,
            0,
            null,
            null);
    Answer<TaskView> answer =
        stage.fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    return ((Answer.Accepted<TaskView>) answer).value().id();
  }

  @Test
  void itIsLentAsAWholeReleasedStoredAndGivenBack() throws Exception {
    long task = drive(true);
    stage.await(_ -> !rooms().isEmpty());
    Room lent = rooms().getFirst();
    FreeZone zone = Objects.requireNonNull(lent.zone());
    assertEquals(new FreeZone(5, 0, 6, 3, zone.speed(), List.of()), zone);
    assertTrue(zone.speed() > 0);
    stage.await(_ -> isStored());
    robot().returnRoom();
    stage.await(_ -> !isStored());
    stage.await(view -> HallFleetTest.task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aServerThatStartsAnewKeepsItUntilItIsGivenBack() throws Exception {
    long task = drive(true);
    stage.await(_ -> !rooms().isEmpty() && isStored());
    robot().setStuck(true);
    stage.restart();
    stage.await(view -> HallFleetTest.robot(view, "r1").state() == RobotState.DRIVING);
    stage.pass(Duration.ofSeconds(3));
    assertTrue(isStored());
    assertEquals(1, rooms().size());

    robot().returnRoom();
    stage.await(_ -> !isStored());
    robot().setStuck(false);
    stage.await(view -> HallFleetTest.task(view, task).state() == TaskState.DONE);
  }

  @Test
  void whatItRefusesIsNotKeptForIt() throws Exception {
    long task = drive(true);
    robot().refuseRoom();
    stage.await(view -> HallFleetTest.task(view, task).state() == TaskState.DONE);
    stage.await(_ -> !isStored());
  }

  @Test
  void aRobotThatDoesNotSaySoFollowsItsPathThroughIt() throws Exception {
    long task = drive(false);
    stage.await(view -> HallFleetTest.task(view, task).state() == TaskState.DONE);
    assertEquals(List.of(), rooms());
  }

  @Test
  void whoFallsSilentInItKeepsItUntilHeard() throws Exception {
    long task = untilSilentInIt();
    long other = submit("r2", new Vec2(13.5, 2.5), new Vec2(2.5, 2.5));
    stage.await(view -> isInState(view, other, TaskState.CARRYING));
    stage.pass(Duration.ofMinutes(2)); // long after its task would have gone to another
    assertOnlyTheSilentOneHasIt();

    robot().setStuck(false);
    robot().speakAgain();
    stage.await(view -> HallFleetTest.task(view, task).state() == TaskState.DONE);
    stage.await(view -> isInState(view, other, TaskState.DONE));
  }

  @Test
  void whoFallsSilentInItKeepsItUntilAPersonSaysThatItIsGone() throws Exception {
    untilSilentInIt();
    long other = submit("r2", new Vec2(13.5, 2.5), new Vec2(2.5, 2.5));
    stage.await(view -> isInState(view, other, TaskState.CARRYING));
    stage.restart(); // a server that starts anew knows it no better
    stage.pass(Duration.ofMinutes(2));
    assertOnlyTheSilentOneHasIt();

    HallFleetTest.accepted(stage.fleet.takeOutOfService("r1", "Max"));
    stage.await(view -> isInState(view, other, TaskState.DONE));
  }

  /** Also before it is shown. */
  private static boolean isInState(FleetSnapshot view, long task, TaskState state) {
    return view.tasks().stream().anyMatch(t -> t.id() == task && t.state() == state);
  }

  /** The task of r1, which stands in the zone and is not heard. */
  private long untilSilentInIt() throws Exception {
    stage.add("r2", new Vec2(13.5, 0.5), null);
    long task = drive(true);
    stage.await(_ -> isStored() && robot().position().x() > 6);
    robot().setStuck(true);
    robot().fallSilent();
    stage.await(view -> HallFleetTest.robot(view, "r1").state() == RobotState.LOST);
    return task;
  }

  private void assertOnlyTheSilentOneHasIt() throws Exception {
    assertTrue(isStored());
    Vec2 waits = stage.scriptedRobot("r2").position();
    assertTrue(waits.x() > 11, () -> "r2 is at " + waits);
    stage.await(view -> HallFleetTest.robot(view, "r2").work().doing().english().contains("r1"));
  }

  private long submit(String robot, Vec2 from, Vec2 to) throws Exception {
    TaskOrder order =
        new TaskOrder(
            "other box",
            1,
            new Where.Point(from),
            new Where.Point(to),
            null,
            0,
            null,
            null,
            List.of(robot),
            List.of(),
            null);
    return ((Answer.Accepted<TaskView>)
            stage.fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS))
        .value()
        .id();
  }

  private ScriptedRobot robot() {
    return stage.scriptedRobot("r1");
  }

  private List<Room> rooms() {
    return robot().obeyed().stream()
        .filter(Room.class::isInstance)
        .map(Room.class::cast)
        .filter(room -> room.zone() != null)
        .toList();
  }

  private boolean isStored() {
    return stage
        .database
        .jdbi()
        .withHandle(h -> h.createQuery("select zone_width from drives").mapTo(Double.class).list())
        .stream()
        .anyMatch(Objects::nonNull);
  }
}
