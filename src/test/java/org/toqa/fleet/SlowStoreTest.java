package org.toqa.fleet;

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
}
