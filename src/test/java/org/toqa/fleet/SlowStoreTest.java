package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/** A robot waits until the store has taken what it did, and its task says so. */
class SlowStoreTest extends HallFleetTest {
  @Test
  void taskWhoseRobotWaitsForTheStoreSaysSo() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    stage.stopStoreFor(agent -> agent.startsWith("floor"));

    until(
        view ->
            task(view, task).state() == TaskState.RETURNING
                && Phrase.NOT_STORED_YET.with().equals(task(view, task).waitingFor()));

    stage.startStore();
    until(view -> task(view, task).waitingFor() == null);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aRobotThatMayStillBeStoredKeepsItsName() throws Exception {
    RobotOrder late = new RobotOrder("late", "127.0.0.1", 1, 5, null, null, null, null, null);
    stage.stopStoreFor(_ -> true);
    CompletableFuture<Answer<RobotView>> added =
        stage.fleet.addRobot(late, "Max").toCompletableFuture();
    assertThrows(ExecutionException.class, () -> added.get(30, TimeUnit.SECONDS));
    assertEquals(
        new Answer.Rejected<>("name", Phrase.ROBOT_NAME_TAKEN.with("late")),
        stage.fleet.addRobot(late, "Max").toCompletableFuture().get(30, TimeUnit.SECONDS));

    stage.startStore();
    until(view -> view.robots().stream().anyMatch(robot -> robot.name().equals("late")));
    assertInstanceOf(
        Answer.Accepted.class,
        stage
            .fleet
            .takeOutOfService("late", "Max")
            .toCompletableFuture()
            .get(30, TimeUnit.SECONDS));
  }

  @Test
  void aRobotThatIsNotStoredGivesItsNameBack() throws Exception {
    for (int tries = 0; tries < 2; tries++) {
      assertEquals(
          "parking",
          assertInstanceOf(
                  Answer.Rejected.class,
                  stage
                      .fleet
                      .addRobot(
                          new RobotOrder(
                              "late", "127.0.0.1", 1, 5, "Nowhere", null, null, null, null),
                          "Max")
                      .toCompletableFuture()
                      .get(30, TimeUnit.SECONDS))
              .field());
    }
  }
}
