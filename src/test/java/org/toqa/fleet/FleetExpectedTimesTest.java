package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;

/** When tasks are expected to be picked up and delivered. */
class FleetExpectedTimesTest extends HallFleetTest {
  @Test
  void tasksSayWhenTheyWillBeDeliveredUntilTheyAre() throws Exception {
    long first = submit("West", "East");
    long second = submit("East", "West");
    until(view -> delivery(view, second) != null && delivery(view, first) != null);

    FleetSnapshot view = stage.fleet.snapshots().latest();
    Instant last = Objects.requireNonNull(delivery(view, second));
    assertTrue(Objects.requireNonNull(delivery(view, first)).isBefore(last));
    assertTrue(Objects.requireNonNull(times(view, second).pickUp()).isBefore(last));

    until(now -> task(now, second).state() == TaskState.RETURNING);
    assertNull(task(stage.fleet.snapshots().latest(), second).expected());
    assertTrue(keptOf(first).getFirst());
    assertTrue(keptOf(second).getFirst());
  }

  @Test
  void whatDependsOnAPersonSaysSo() throws Exception {
    long task =
        submit(
            order(1)
                .along(
                    List.of(
                        new StopOrder(new Where.Station("West"), false, null),
                        new StopOrder(new Where.Station("East"), true, null),
                        new StopOrder(new Where.Station("West"), false, null))));
    until(view -> task(view, task).expected() != null);
    ExpectedTimes times = times(stage.fleet.snapshots().latest(), task);
    assertNotNull(times.pickUp());
    assertNull(times.delivery());
    assertEquals("This depends on when somebody says “Go on”.", String.valueOf(times.unknown()));

    accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Clara")));
    untilUnknown(task, "This depends on when it is resumed.");
    accepted(stage.fleet.commandTask(task, new MissionEvent.Resume("Clara")));
    until(view -> task(view, task).isWaitingAtStop());
    accepted(stage.fleet.commandTask(task, new MissionEvent.GoOn("Clara", null)));
    until(view -> delivery(view, task) != null);
  }

  private void untilUnknown(long task, String sentence) throws InterruptedException {
    until(
        view ->
            task(view, task).expected() != null
                && sentence.equals(String.valueOf(times(view, task).unknown())));
  }

  private static ExpectedTimes times(FleetSnapshot view, long task) {
    return Objects.requireNonNull(task(view, task).expected());
  }

  private static @Nullable Instant delivery(FleetSnapshot view, long task) {
    ExpectedTimes times = task(view, task).expected();
    return times == null ? null : times.delivery();
  }

  /** Whether it is kept what was expected at the order, and at the start. */
  private List<Boolean> keptOf(long task) {
    return stage
        .database
        .jdbi()
        .withHandle(
            h ->
                h.createQuery(
                        "select expected_at_order, expected_at_start from tasks where id = :id")
                    .bind("id", task)
                    .map(
                        (row, _) ->
                            List.of(row.getTimestamp(1) != null, row.getTimestamp(2) != null))
                    .one());
  }
}
