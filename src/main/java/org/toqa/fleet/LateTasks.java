package org.toqa.fleet;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Tells at once which tasks will not be delivered by their deadlines. */
final class LateTasks {
  private static final Duration LOOK_EVERY = Duration.ofSeconds(1);

  private final FleetState fleet;
  private final DeadlineWatch deadlines;
  private Instant nextLook = Instant.MIN;

  LateTasks(FleetState fleet, DeadlineWatch deadlines) {
    this.fleet = fleet;
    this.deadlines = deadlines;
  }

  /** The task with what is known of its deadline. */
  TaskView told(TaskView task) {
    return deadlines.told(task);
  }

  void look(Instant now) {
    if (now.isBefore(nextLook)) {
      return;
    }
    nextLook = now.plus(LOOK_EVERY);
    List<EventRecord> late =
        Stream.concat(
                fleet
                    .queue
                    .first(FleetState.LOOKED_AT)
                    .map(q -> FleetState.view(q, FleetState.NOT_LOOKED_AT)),
                fleet.reports.values().stream().flatMap(r -> r.missions().stream()))
            .flatMap(task -> look(task).stream())
            .toList();
    if (!late.isEmpty()) {
      fleet.changed = true;
      fleet.writer.write(() -> fleet.store.addEvents(late), () -> {});
    }
  }

  /** A line for the history if it has just become clear that the task will be late. */
  Optional<EventRecord> look(TaskView task) {
    if (!DeadlineWatch.isDue(task)) {
      return Optional.empty();
    }
    String floor = task.task().floor();
    Map<Long, TaskView> here =
        fleet.missions(floor).stream().collect(Collectors.toMap(TaskView::id, t -> t));
    Forecast forecast = new Forecast(requireNonNull(fleet.distances.get(floor)));
    Instant at = fleet.clock.instant();
    return deadlines
        .look(task, forecast.of(task, fleet.robotViews(floor), here), at)
        .map(
            sentence ->
                new EventRecord(at, "task.late", task.id(), null, EventRecord.SYSTEM, sentence));
  }
}
