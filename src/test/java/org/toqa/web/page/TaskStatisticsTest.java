package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;

class TaskStatisticsTest {
  private static final Instant MIDNIGHT = Instant.parse("2026-11-21T00:00:00Z");

  @Test
  void countsAndMeansAreOverTheTasksGiven() {
    TaskStatistics statistics =
        TaskStatistics.of(
            List.of(
                task(TaskState.DONE, -100, -40), // yesterday, 60 s
                task(TaskState.DONE, -10, 0), // today, 10 s
                task(TaskState.FAILED, 0, 500),
                task(TaskState.QUEUED, 0, 0)),
            MIDNIGHT);

    assertEquals(4, statistics.looked());
    assertEquals(2, statistics.byState().get(TaskState.DONE));
    assertEquals(0, statistics.byState().get(TaskState.CARRYING));
    assertEquals(1, statistics.doneToday());
    assertEquals(35.0, statistics.meanSeconds()); // (60 + 10) / 2
  }

  @Test
  void withoutATaskThatIsDoneThereIsNoMean() {
    assertNull(TaskStatistics.of(List.of(), MIDNIGHT).meanSeconds());
  }

  /** Times in seconds after midnight. */
  private static TaskView task(TaskState state, long created, long changed) {
    TaskPlace place = new TaskPlace(Vec2.ZERO, null);
    return new TaskView(
        new TransportTask(
            1, "x", 1, place, place, "hall", 0, null, null, "ada", MIDNIGHT.plusSeconds(created)),
        state,
        false,
        List.of(),
        null,
        null,
        null,
        null,
        MIDNIGHT.plusSeconds(changed));
  }
}
