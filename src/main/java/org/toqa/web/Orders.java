package org.toqa.web;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TaskState;

/** Orders as readers see them, with what the fleet knows now of their tasks. */
public final class Orders {
  private final Services services;
  private final Tasks tasks;

  public Orders(Services services) {
    this.services = services;
    this.tasks = new Tasks(services);
  }

  public Optional<OrderView> order(long id) {
    return services.orders().order(id).map(order -> order.withTasks(tasks.live()));
  }

  /** Newest first. */
  public List<OrderView> page(int offset, int limit) {
    return live(services.orders().orders(offset, limit));
  }

  public long count() {
    return services.orders().orderCount();
  }

  /** The orders that these tasks are parts of, by id. */
  public Map<Long, OrderView> of(List<TaskView> parts) {
    List<Long> ids =
        parts.stream()
            .flatMap(task -> Stream.ofNullable(task.task().part()))
            .map(OrderPart::order)
            .distinct()
            .toList();
    return live(services.orders().orders(ids)).stream()
        .collect(Collectors.toMap(OrderView::id, Function.identity()));
  }

  private List<OrderView> live(List<OrderView> stored) {
    var live = tasks.live();
    return stored.stream().map(order -> order.withTasks(live)).toList();
  }

  /**
   * Tells what robots stop for to what the fleet has of an order, and waits for nothing: also while
   * the order cannot be read, and however long its store takes. Who tells all of it afterwards
   * tells these the same again.
   *
   * @param mayBeTold judges what the fleet has
   */
  public void tellAtOnce(
      long id, Predicate<OrderView> mayBeTold, MissionEvent.OperatorCommand command) {
    liveOrder(id)
        .filter(mayBeTold)
        .ifPresent(
            order ->
                order
                    .open()
                    .reversed()
                    .forEach(task -> services.fleet().commandTask(task.id(), command)));
  }

  /** Only as far as the fleet has it: of what is queued there may be more. */
  private Optional<OrderView> liveOrder(long id) {
    List<TaskView> there =
        services.fleet().snapshots().latest().tasks().stream()
            .filter(task -> task.task().part() != null && task.task().part().order() == id)
            .sorted(Comparator.comparingLong(TaskView::id))
            .toList();
    return there.stream()
        .findFirst()
        .map(
            task -> {
              OrderPart part = Objects.requireNonNull(task.task().part());
              return new OrderView(
                  id, part.name(), part.kind(), part.count(), task.task().createdAt(), there);
            });
  }

  /**
   * Cancels all of an order that is not delivered, one task after the other, those with the load on
   * board first: where nobody said what becomes of that nothing is cancelled. Repeated, it cancels
   * what is left.
   *
   * @return why not, where a person must say more
   */
  public @Nullable Answer<TaskView> cancel(OrderView order, MissionEvent.Cancel cancel) {
    List<TaskView> open =
        order.open().reversed().stream()
            .sorted(Comparator.comparing((TaskView task) -> task.state() != TaskState.CARRYING))
            .toList();
    for (TaskView task : open) {
      Answer<TaskView> answer = FleetAnswers.await(services.fleet().commandTask(task.id(), cancel));
      if (answer instanceof Answer.Conflict<TaskView> conflict && conflict.needs() != null) {
        return answer;
      } // any other no: it has ended or is delivered by now
    }
    return null;
  }

  /**
   * Tells the same to all of an order that is not delivered, one task after the other, the last one
   * first: so no leg begins since the one before it was not yet held. Repeated, it tells what is
   * left.
   *
   * @return false: nothing of it could be told, since all has ended or is delivered by now
   */
  public boolean tellOpen(OrderView order, MissionEvent.OperatorCommand command) {
    boolean isTold = false;
    for (TaskView task : order.open().reversed()) {
      Answer<TaskView> answer =
          FleetAnswers.await(services.fleet().commandTask(task.id(), command));
      isTold |= answer instanceof Answer.Accepted<TaskView>;
    }
    return isTold;
  }
}
