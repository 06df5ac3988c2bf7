package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.Views;

class TaskLoadGeneratorTest {
  private static final Instant NOON = Instant.parse("2026-06-01T12:00:00Z");
  private static final TaskPlace PLACE = new TaskPlace(Vec2.ZERO, null);

  /** Else the queue of a large fleet would grow for as long as it is measured. */
  @Test
  void queuedTasksThatASnapshotDoesNotShowAreOpenToo() {
    List<TaskView> shown =
        List.of(
            task(5, TaskState.QUEUED),
            task(4, TaskState.QUEUED),
            task(3, TaskState.CARRYING),
            task(2, TaskState.ASSIGNED),
            task(1, TaskState.DONE));
    FleetSnapshot snapshot =
        new FleetSnapshot(
            1, NOON, List.of(), shown, 240, List.of(), null, Map.of(), Map.of(), List.of());

    assertEquals(242, TaskLoadGenerator.openTasks(snapshot)); // 240 queued, and 3 and 2
  }

  private static TaskView task(long id, TaskState state) {
    TransportTask task =
        new TransportTask(id, "t", 2, PLACE, PLACE, "hall", 0, null, null, "boss", NOON);
    return Views.task(task, state, false, List.of(), null, null, false, null, null, NOON);
  }
}
