package org.toqa.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;

/**
 * What of an order has ended without delivery, ordered anew: each part from where its load is.
 *
 * @param parts which part each of the orders is
 */
public record PartsToRetry(List<TaskOrder> orders, List<OrderPart> parts) {
  public PartsToRetry {
    orders = List.copyOf(orders);
    parts = List.copyOf(parts);
  }

  public static PartsToRetry of(OrderView order) {
    List<TaskOrder> orders = new ArrayList<>();
    List<OrderPart> parts = new ArrayList<>();
    for (TaskView ended : order.undelivered()) {
      OrderPart part = ended.task().part();
      if (part != null && !isPassedOver(order, part)) {
        orders.add(order(ended));
        parts.add(
            part.withAwaitsPrevious(part.awaitsPrevious() && !isPreviousDelivered(order, part)));
      }
    }
    return new PartsToRetry(orders, parts);
  }

  /** Whether a person has let the leg after it begin without it. */
  private static boolean isPassedOver(OrderView order, OrderPart part) {
    return part.kind() == OrderPart.Kind.STOPS
        && order.current().stream()
            .flatMap(task -> Stream.ofNullable(task.task().part()))
            .anyMatch(next -> next.position() == part.position() + 1 && !next.awaitsPrevious());
  }

  private static boolean isPreviousDelivered(OrderView order, OrderPart part) {
    OrderPart.Previous previous = order.previous(part);
    return previous != null && previous.state().isDelivered();
  }

  private static TaskOrder order(TaskView ended) {
    TransportTask task = ended.task();
    return new TaskOrder(
        task.name(),
        task.load(),
        where(ended.object()),
        where(task.goal()),
        task.floor(),
        task.priority(),
        task.deadline(),
        task.size(),
        task.onlyRobots(),
        List.of(),
        task.arm());
  }

  private static Where where(TaskPlace place) {
    String station = place.station();
    return station == null ? new Where.Point(place.position()) : new Where.Station(station);
  }
}
