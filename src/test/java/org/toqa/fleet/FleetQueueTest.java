package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Role;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.store.JdbiAccountStore;
import org.toqa.store.LastKnownUsers;

/** Tasks that wait for robots: why, and in which order. */
class FleetQueueTest extends HallFleetTest {
  @Test
  void aTeamThatHadNoRoomIsAskedAgainAfterAMinuteWhateverTheClockIsSetTo() throws Exception {
    stage.add("r2", new Vec2(8.5, 1.5), null);
    reopenWith("r3", new Vec2(11.5, 1.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    long task =
        submit(
            new TaskOrder(
                "plate",
                8,
                new Where.Point(new Vec2(5.5, 1.5)),
                new Where.Point(new Vec2(12.5, 1.5)),
                null,
                0,
                null,
                null));
    setFootprints(1.2);
    accepted(stage.fleet.putInService("r2", "Max"));
    until(view -> waitReason(view, task).contains("no room"));

    stage.setClock(Duration.ofHours(-2));
    setFootprints(ScriptedRobot.FOOTPRINT);

    until(view -> task(view, task).state() == TaskState.TO_OBJECT);
  }

  /** Of both that carry it, with which they connect anew. */
  private void setFootprints(double diameter) {
    for (String name : List.of("r2", "r3")) {
      scriptedRobot(name).setFootprint(diameter);
      scriptedRobot(name).loseConnection();
      scriptedRobot(name).speakAgain();
    }
  }

  @Test
  void aLoadTooHeavyForOneWaitsAndSaysWhatItNeeds() throws Exception {
    submitForTwoOfWhichOneIsBroken();

    double most = robot(stage.fleet.snapshots().latest(), "r1").maxLoad();
    Answer<TaskView> tooHeavy =
        stage
            .fleet
            .submit(orderForSeveral(3 * most), "Clara")
            .toCompletableFuture()
            .get(10, TimeUnit.SECONDS);
    assertInstanceOf(Answer.Rejected.class, tooHeavy);
  }

  @Test
  void aTaskThatNoRobotsCanEverCarryNeedsAttention() throws Exception {
    long task = submitForTwoOfWhichOneIsBroken();
    assertFalse(task(stage.fleet.snapshots().latest(), task).blocked(), "r2 may be mended");

    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    accepted(stage.fleet.removeRobot("r2", "Max"));

    until(view -> task(view, task).blocked());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max")));
    until(view -> !task(view, task).blocked());
  }

  @Test
  void aTaskForOneRobotWaitsForThatOneAlsoAfterARestart() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.holdRobot("r2", "Max"));
    until(view -> robot(view, "r2").work().held());

    long task = submit(only(1, "r2"));
    until(view -> "Only r2 may do this, and it is on hold.".equals(waitReason(view, task)));
    stage.restart();
    until(
        view ->
            robot(view, "r1").state() == RobotState.IDLE
                && "Only r2 may do this, and it is on hold.".equals(waitReason(view, task)));
    accepted(stage.fleet.resumeRobot("r2", "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("r2"), stage.store.task(task).orElseThrow().robots());
  }

  @Test
  void aTaskForRobotsThatCanNeverDoItIsRefused() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    double most = robot(stage.fleet.snapshots().latest(), "r2").maxLoad();

    assertEquals(
        "There is no robot r9 on the floor hall; there are: r1, r2.", refusal(only(1, "r1", "r9")));
    assertEquals(
        "The load weighs %.0f kg; r2 can carry %.0f kg. Allow more or stronger robots, or split the load."
            .formatted(2 * most, most),
        refusal(only(2 * most, "r2")));
  }

  @Test
  void aTaskWhoseOnlyRobotIsRemovedNeedsAttention() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    long task = submit(only(1, "r2"));
    until(view -> "Only r2 may do this, and it is out of service.".equals(waitReason(view, task)));

    accepted(stage.fleet.removeRobot("r2", "Max"));

    until(view -> task(view, task).blocked());
    assertEquals(
        "Only r2 may do this, and there is no such robot on this floor. Order it anew for others, or cancel it.",
        waitReason(stage.fleet.snapshots().latest(), task));
  }

  @Test
  void anAbilityThatNoRobotHasIsRefused() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);

    assertEquals(
        "Only robots with an arm may do this, and none that has ever been connected is on this"
            + " floor. Choose other robots, or connect such a robot.",
        refusal(only(1, "with:arm")));
  }

  private static TaskOrder only(double load, String... robots) {
    TaskOrder order = order(load);
    return new TaskOrder(
        order.name(),
        load,
        order.start(),
        order.goal(),
        null,
        0,
        null,
        null,
        List.of(robots),
        List.of());
  }

  private String refusal(TaskOrder order) throws Exception {
    Answer<TaskView> answer = answer(stage.fleet.submit(order, "Clara"));
    Answer.Rejected<?> rejected = assertInstanceOf(Answer.Rejected.class, answer);
    assertEquals("onlyRobots", rejected.field());
    return rejected.sentence().english();
  }

  @Test
  void aTaskOfHigherPriorityComesFirstAlsoAfterARestart() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long first = accepted(stage.fleet.submit(order(1), "Clara")).id();
    long second = accepted(stage.fleet.submit(order(1), "Clara")).id();

    TaskView changed =
        accepted(stage.fleet.commandTask(second, new MissionEvent.Prioritise("Clara", 10)));

    assertEquals(10, changed.task().priority());
    EventRecord told = stage.store.history(second).getLast();
    assertEquals("task.prioritised", told.kind());
    assertEquals("Clara changed the priority from 0 to 10", told.text());
    accepted(stage.fleet.commandTask(second, new MissionEvent.Prioritise("Clara", 10)));
    assertEquals(told, stage.store.history(second).getLast(), "nothing to tell");
    stage.restart();
    until(view -> view.queuedCount() == 2 && task(view, second).task().priority() == 10);
    accepted(stage.fleet.putInService("r1", "Max"));
    until(view -> !task(view, second).robots().isEmpty());
    assertEquals(TaskState.QUEUED, task(stage.fleet.snapshots().latest(), first).state());
  }

  @Test
  void aPriorityThatAnotherHasChangedSinceItWasSeenIsNotChanged() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long task = submit(order(1));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Prioritise("Clara", 10, 0)));

    assertInstanceOf(
        Answer.Outdated.class,
        answer(stage.fleet.commandTask(task, new MissionEvent.Prioritise("Max", 5, 0))));

    assertEquals(10, stage.store.task(task).orElseThrow().task().priority());
    accepted(stage.fleet.putInService("r1", "Max"));
    until(view -> !task(view, task).robots().isEmpty());
    assertInstanceOf(
        Answer.Outdated.class,
        answer(stage.fleet.commandTask(task, new MissionEvent.Prioritise("Max", 5, 0))));
    accepted(stage.fleet.commandTask(task, new MissionEvent.Prioritise("Max", 5, 10)));
    assertEquals(5, stage.store.task(task).orElseThrow().task().priority());
  }

  @Test
  void aTaskIsHandedOverToAnotherUserWhoKeepsItAlsoAfterARestart() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    JdbiAccountStore accounts =
        new JdbiAccountStore(stage.database.jdbi(), InstantSource.system(), new LastKnownUsers());
    long clara = accounts.add("Clara", "hash", Role.CLERK, "Max").orElseThrow().id();
    long omar = accounts.add("Omar", "hash", Role.CLERK, "Max").orElseThrow().id();
    TaskView given = accepted(stage.fleet.submit(order(1), "clara"));
    assertEquals(clara, given.task().owner());

    MissionEvent.HandOver handOver = new MissionEvent.HandOver("Max", "Omar", omar);
    assertEquals(omar, accepted(stage.fleet.commandTask(given.id(), handOver)).task().owner());

    EventRecord told = stage.store.history(given.id()).getLast();
    assertEquals("task.handed-over", told.kind());
    assertEquals("Max handed the task of clara over to Omar", told.text());
    stage.restart();
    until(view -> view.queuedCount() == 1);
    TaskView again = task(stage.fleet.snapshots().latest(), given.id());
    assertEquals(omar, again.task().owner());
    assertEquals("Omar", again.task().user());
    // what is stored after its user has gone is nobody's
    stage.database.jdbi().useHandle(h -> h.execute("delete from users"));
    accepted(stage.fleet.commandTask(given.id(), new MissionEvent.Hold("Max")));
    assertNull(stage.store.task(given.id()).orElseThrow().task().owner());
  }

  @Test
  void ofALongQueueTheFirstOnesAreShownAndAllAreCounted() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long first = accepted(stage.fleet.submit(order(1), "Clara")).id();
    for (int i = 1; i < 150; i++) {
      accepted(stage.fleet.submit(order(1), "Clara"));
    }
    TaskOrder urgent =
        new TaskOrder(
            "urgent", 1, new Where.Station("West"), new Where.Station("East"), null, 9, null, null);
    long last = accepted(stage.fleet.submit(urgent, "Clara")).id();

    until(view -> view.queuedCount() == 151 && view.tasks().size() == 100);

    FleetSnapshot view = stage.fleet.snapshots().latest();
    assertEquals(last, view.tasks().getFirst().id());
    assertEquals(first, view.tasks().getLast().id());
    accepted(stage.fleet.putInService("r1", "Max"));
    until(later -> later.tasks().stream().anyMatch(t -> t.id() == last && t.robots().size() == 1));
    assertEquals(150, stage.fleet.snapshots().latest().queuedCount());
  }

  /**
   * @return the task, which waits for the second robot
   */
  private long submitForTwoOfWhichOneIsBroken() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    double most = robot(stage.fleet.snapshots().latest(), "r1").maxLoad();
    stage.scriptedRobot("r2").breakDown("BUMPER");
    until(view -> robot(view, "r2").state() == RobotState.ERROR);
    long task = submit(orderForSeveral(1.5 * most));
    until(view -> waitReason(view, task).equals("It needs 2 robots together; 1 of 2 is free."));
    return task;
  }
}
