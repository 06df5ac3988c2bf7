package org.toqa.fleet.manager;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskView;

/** Tells at once which tasks will not be delivered by their deadlines. */
final class LateTaskReporter {
  private static final Duration CHECK_INTERVAL = Duration.ofSeconds(1);

  private final FleetState fleet;
  private final DeadlineWatch deadlineWatch;
  private Instant nextCheck = Instant.MIN;

  LateTaskReporter(FleetState fleet, DeadlineWatch deadlines) {
    this.fleet = fleet;
    this.deadlineWatch = deadlines;
  }

  /** The task with what is known of its deadline. */
  TaskView withLateness(TaskView task) {
    return deadlineWatch.withLateness(task);
  }

  void check(Instant now) {
    if (now.isBefore(nextCheck)) {
      return;
    }
    nextCheck = now.plus(CHECK_INTERVAL);
    List<EventRecord> late =
        Stream.concat(
                fleet
                    .queue
                    .first(FleetState.TASKS_CONSIDERED)
                    .map(q -> FleetState.view(q, FleetState.LOOKING_FOR_ROBOT)),
                fleet.reports.values().stream().flatMap(r -> r.missions().stream()))
            .flatMap(task -> check(task).stream())
            .toList();
    if (!late.isEmpty()) {
      fleet.changed = true;
      fleet.writer.write(() -> fleet.store.addEvents(late), () -> {});
    }
  }

  /** A line for the history if it has just become clear that the task will be late. */
  Optional<EventRecord> check(TaskView task) {
    if (!DeadlineWatch.hasOpenDeadline(task)) {
      return Optional.empty();
    }
    String floor = task.task().floor();
    Map<Long, TaskView> here =
        fleet.assignedTasks(floor).stream().collect(Collectors.toMap(TaskView::id, t -> t));
    DeliveryForecast forecast = new DeliveryForecast(requireNonNull(fleet.distances.get(floor)));
    Instant at = fleet.clock.instant();
    return deadlineWatch
        .check(task, forecast.earliestDelivery(task, fleet.robotsOn(floor), here), at)
        .map(
            sentence ->
                new EventRecord(
                    at, EventKind.TASK_LATE, task.id(), null, EventRecord.SYSTEM, sentence));
  }
}
