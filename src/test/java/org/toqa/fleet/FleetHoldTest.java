package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/** Tasks, robots, floors and the whole fleet on hold. */
class FleetHoldTest extends HallFleetTest {
  @Test
  void aTaskOnHoldStandsAndSaysSoAndGoesOnAfterARestart() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    assertTrue(accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max"))).held());
    until(view -> scriptedRobot("r1").isHeld() && robot(view, "r1").state() == RobotState.HOLDING);
    Vec2 stopped = scriptedRobot("r1").position();
    stage.restart();
    until(view -> !view.robots().isEmpty() && robot(view, "r1").state() == RobotState.HOLDING);
    assertTrue(task(stage.fleet.snapshots().latest(), task).held());
    assertEquals(
        "Task " + task + " is on hold", waitReason(stage.fleet.snapshots().latest(), task));
    assertEquals(stopped, scriptedRobot("r1").position());

    accepted(stage.fleet.commandTask(task, new MissionEvent.Resume("Max")));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("Max put the task on hold"), history("task.held"));
    assertEquals(List.of("Max resumed the task"), history("task.resumed"));
  }

  @Test
  void aPauseOvertakesWhatWasAskedBefore() throws Exception {
    untilCarryingOnTheWay(submit("West", "East"));
    long waiting = submit("East", "West");
    AtomicInteger answered = new AtomicInteger();
    AtomicInteger answeredBeforeItStood = new AtomicInteger();
    List<CompletableFuture<?>> asked = new ArrayList<>();
    stage.holdUp(
        Duration.ZERO,
        () -> {
          for (int i = 0; i < 100; i++) {
            asked.add(
                stage
                    .fleet
                    .commandTask(waiting, new MissionEvent.Hold("Max"))
                    .thenAccept(
                        answer -> {
                          answered.incrementAndGet();
                          if (!scriptedRobot("r1").isHeld()) {
                            answeredBeforeItStood.incrementAndGet();
                          }
                        })
                    .toCompletableFuture());
          }
          asked.add(stage.fleet.pauseAll("Max").toCompletableFuture());
        });
    CompletableFuture.allOf(asked.toArray(CompletableFuture[]::new)).get(60, TimeUnit.SECONDS);

    assertEquals(100, answered.get());
    assertTrue(answeredBeforeItStood.get() < 20, () -> "after " + answeredBeforeItStood);
  }

  @Test
  void aRobotOnHoldStandsUntilItIsLetGoOn() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    assertTrue(accepted(stage.fleet.holdRobot("r1", "Max")).work().held());
    until(view -> robot(view, "r1").state() == RobotState.HOLDING);
    stage.restart();
    until(view -> !view.robots().isEmpty() && robot(view, "r1").work().held());
    assertEquals(TaskState.CARRYING, task(stage.fleet.snapshots().latest(), task).state());
    accepted(stage.fleet.resumeRobot("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("Max put r1 on hold"), history("robot.held"));
  }

  @Test
  void whileAFloorIsOnHoldItsRobotsStandAlsoAfterARestart() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    assertEquals(
        new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with("attic")),
        stage.fleet.holdFloor("attic", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS));

    assertEquals("Max", accepted(stage.fleet.holdFloor("hall", "Max")).orElseThrow().user());
    until(view -> robot(view, "r1").state() == RobotState.HOLDING);
    Vec2 stopped = scriptedRobot("r1").position();
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.HOLDING));
    FleetSnapshot held = stage.fleet.snapshots().latest();
    assertEquals("Max", Objects.requireNonNull(held.floors().getFirst().hold()).user());
    assertEquals(Phrase.FLOOR_HELD_BY.with("hall", "Max"), robot(held, "r1").work().doing());
    assertEquals(Phrase.FLOOR_HELD_BY.with("hall", "Max"), task(held, task).waitingFor());
    assertEquals(stopped, scriptedRobot("r1").position());

    assertEquals(Optional.empty(), accepted(stage.fleet.resumeFloor("hall", "Boss")));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("Max put all robots of hall on hold"), history("floor.held"));
    assertEquals(List.of("Boss resumed all robots of hall"), history("floor.resumed"));
  }

  @Test
  void whileAllArePausedNoRobotDrivesAndOneThatConnectsIsHeldToo() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    assertEquals("Max", accepted(stage.fleet.pauseAll("Max")).orElseThrow().user());
    until(view -> scriptedRobot("r1").isHeld());
    Vec2 stopped = scriptedRobot("r1").position();
    reopenWith("r2", EAST, "P2");
    until(
        view ->
            scriptedRobot("r2").isHeld()
                && view.robots().stream().allMatch(r -> r.state() == RobotState.HOLDING));
    assertEquals("Max", Objects.requireNonNull(stage.fleet.snapshots().latest().pause()).user());
    assertEquals(stopped, scriptedRobot("r1").position());
    assertEquals(
        Phrase.ALL_PAUSED_BY.with("Max"),
        robot(stage.fleet.snapshots().latest(), "r1").work().doing());
    long queued = submit("East", "West");
    until(view -> Phrase.ALL_PAUSED_BY.with("Max").equals(task(view, queued).waitingFor()));

    accepted(stage.fleet.resumeAll("Boss"));

    until(view -> task(view, task).state() == TaskState.DONE && view.pause() == null);
    assertEquals(List.of("Max paused all robots"), history("fleet.paused"));
    assertEquals(List.of("Boss resumed all robots"), history("fleet.resumed"));
  }
}
