package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.dispatch.DeliveryForecast.Delivery;

/**
 * Tells at once which tasks will not be delivered by their deadlines. When they can be delivered is
 * computed on a thread of its own, and comes back as a message.
 */
final class LateTaskReporter {
  private static final Logger log = LoggerFactory.getLogger(LateTaskReporter.class);
  private static final Duration CHECK_INTERVAL = Duration.ofSeconds(1);

  private final DispatchState state;
  private final DeadlineWatch deadlineWatch;
  private final ActorRef<DispatchMessage> self;
  private Instant nextCheck = Instant.MIN;
  private boolean checking;

  LateTaskReporter(DispatchState state, DeadlineWatch deadlines, ActorRef<DispatchMessage> self) {
    this.state = state;
    this.deadlineWatch = deadlines;
    this.self = self;
  }

  /** The task with what is known of its deadline. */
  TaskView withLateness(TaskView task) {
    return deadlineWatch.withLateness(task);
  }

  /** What was said of its old order counts no more. */
  void taskEdited(long task) {
    deadlineWatch.forget(task);
  }

  /** Lets all open deadlines be looked at when it is time. */
  void check(Instant now) {
    if (checking || now.isBefore(nextCheck)) {
      return;
    }
    nextCheck = now.plus(CHECK_INTERVAL);
    List<TaskView> due = openTasks().filter(DeadlineWatch::hasOpenDeadline).toList();
    if (!due.isEmpty()) {
      checking = true;
      forecast(due, earliest -> self.tell(new DispatchMessage.DeadlinesChecked(earliest)));
    }
  }

  void deadlinesChecked(DispatchMessage.DeadlinesChecked m) {
    checking = false;
    List<EventRecord> late =
        openTasks().flatMap(task -> lateness(task, m.earliest()).stream()).toList();
    if (!late.isEmpty()) {
      state.changed = true;
      state.writer.write(() -> state.store.addEvents(late), () -> {});
    }
  }

  private Stream<TaskView> openTasks() {
    return Stream.concat(
        state
            .queue
            .first(DispatchState.TASKS_CONSIDERED)
            .map(q -> DispatchState.view(q, DispatchState.LOOKING_FOR_ROBOT)),
        state.assignedTasks().stream());
  }

  /**
   * Looks at the deadlines of tasks that have just come into the queue.
   *
   * @param reply is given them with what is known of their deadlines; what the history says of that
   *     is safe then
   */
  void checkQueued(List<TaskView> tasks, Consumer<List<TaskView>> reply) {
    if (tasks.stream().noneMatch(DeadlineWatch::hasOpenDeadline)) {
      reply.accept(tasks);
    } else {
      forecast(
          tasks,
          earliest ->
              self.tell(new DispatchMessage.QueuedDeadlinesChecked(tasks, earliest, reply)));
    }
  }

  void queuedDeadlinesChecked(DispatchMessage.QueuedDeadlinesChecked m) {
    List<EventRecord> late =
        m.tasks().stream().flatMap(task -> lateness(task, m.earliest()).stream()).toList();
    List<TaskView> tasks = m.tasks().stream().map(this::withLateness).toList();
    if (late.isEmpty()) {
      m.reply().accept(tasks);
    } else {
      state.changed = true;
      state.writer.write(() -> state.store.addEvents(late), () -> m.reply().accept(tasks));
    }
  }

  /** A line for the history if it has just become clear that the task will be late. */
  private Optional<EventRecord> lateness(TaskView task, Map<Long, Delivery> earliest) {
    Delivery delivery = earliest.get(task.id());
    if (delivery == null || !DeadlineWatch.hasOpenDeadline(task)) {
      return Optional.empty();
    }
    Instant at = state.clock.instant();
    return deadlineWatch
        .check(task, delivery, at)
        .map(
            sentence ->
                new EventRecord(
                    at, EventKind.TASK_LATE, task.id(), null, EventRecord.SYSTEM, sentence));
  }

  /**
   * Computes on a thread of its own, by the fleet as it is now.
   *
   * @param forecast is told when each task can be delivered, by task; those where nobody can say it
   *     are missing
   */
  private void forecast(List<TaskView> tasks, Consumer<Map<Long, Delivery>> forecast) {
    DeliveryForecast floor =
        new DeliveryForecast(state.distances, state.robotsHere(), state.assignedTasks());
    var _ =
        CompletableFuture.supplyAsync(
                () -> earliestDeliveries(tasks, floor),
                state.runtime.threadPerTaskExecutor("forecast"))
            .whenComplete((earliest, failure) -> forecast.accept(orNone(earliest, failure)));
  }

  private static Map<Long, Delivery> earliestDeliveries(
      List<TaskView> tasks, DeliveryForecast floor) {
    Map<Long, Delivery> earliest = new HashMap<>();
    for (TaskView task : tasks) {
      if (DeadlineWatch.hasOpenDeadline(task)) {
        floor.earliestDelivery(task).ifPresent(delivery -> earliest.put(task.id(), delivery));
      }
    }
    return Map.copyOf(earliest);
  }

  private static Map<Long, Delivery> orNone(
      @Nullable Map<Long, Delivery> earliest, @Nullable Throwable failure) {
    if (earliest == null) {
      log.error("Nobody knows which tasks will be late.", failure);
      return Map.of();
    }
    return earliest;
  }
}
