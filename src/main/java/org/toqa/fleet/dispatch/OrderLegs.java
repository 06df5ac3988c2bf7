package org.toqa.fleet.dispatch;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.TaskView;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * How far the legs of orders are, so that a leg begins when the one before it is delivered. Orders
 * without an open leg are forgotten. Confined to one agent.
 */
final class OrderLegs {
  /** By order and position, the newest task. */
  private final Map<Long, Map<Integer, OrderPart.Previous>> orders = new HashMap<>();

  /**
   * @param open tasks that have not ended
   * @param ended legs of their orders that have
   */
  void recover(List<OpenTask> open, List<OpenTask> ended) {
    open.forEach(task -> record(task.mission()));
    ended.forEach(task -> record(task.mission()));
  }

  void record(Mission mission) {
    record(mission.task(), mission.state());
  }

  /**
   * @return whether the leg after it may begin from now on
   */
  boolean record(TaskView view) {
    return record(view.task(), view.state());
  }

  private boolean record(TransportTask task, TaskState state) {
    OrderPart part = task.part();
    if (part == null || part.kind() != OrderPart.Kind.STOPS) {
      return false;
    }
    Map<Integer, OrderPart.Previous> legs =
        orders.computeIfAbsent(part.order(), _ -> new TreeMap<>());
    OrderPart.Previous before = legs.get(part.position());
    if (before == null || before.task() <= task.id()) {
      legs.put(part.position(), new OrderPart.Previous(task.id(), state));
    }
    if (legs.values().stream().allMatch(leg -> leg.state().isEnded())) {
      orders.remove(part.order());
    }
    return state.isDelivered() && (before == null || !before.state().isDelivered());
  }

  private OrderPart.@Nullable Previous previous(OrderPart part) {
    return orders.getOrDefault(part.order(), Map.of()).get(part.position() - 1);
  }

  /** Why the task may not begin yet; empty: it may, or is no leg. */
  Optional<Sentence> reasonToWait(TransportTask task) {
    OrderPart part = task.part();
    return part == null ? Optional.empty() : part.reasonToWait(previous(part));
  }

  /** The task that has to be delivered before it, if that is still to come. */
  OptionalLong taskBefore(TransportTask task) {
    OrderPart part = task.part();
    OrderPart.Previous before = part == null ? null : previous(part);
    return before == null || reasonToWait(task).isEmpty()
        ? OptionalLong.empty()
        : OptionalLong.of(before.task());
  }

  /** Whether the task never begins by itself. */
  boolean isStopped(TransportTask task) {
    OrderPart part = task.part();
    return part != null && part.isStoppedBy(previous(part));
  }

  /** A leg is not let begin while the one before it may still be delivered. */
  Optional<Objection> objectionTo(MissionEvent.OperatorCommand command, Mission mission) {
    return command instanceof MissionEvent.Resume && !mission.held() && !isStopped(mission.task())
        ? reasonToWait(mission.task()).map(why -> new Objection(why, null))
        : Optional.empty();
  }
}
