package org.toqa.web.api;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.OrderState;
import org.toqa.fleet.OrderView;
import org.toqa.mission.OrderPart;
import org.toqa.wording.Sentence;

/**
 * An order of several tasks on the wire.
 *
 * @param parts how many were ordered
 * @param delivered how many of them are at their goals
 * @param held how many of those that are not are on hold
 * @param stuck the parts that do not go on by themselves
 * @param tasks of each part the newest; left out of lists
 */
record OrderJson(
    long id,
    String name,
    OrderPart.Kind kind,
    OrderState state,
    int parts,
    int delivered,
    int held,
    Instant createdAt,
    List<StuckJson> stuck,
    @JsonInclude(JsonInclude.Include.NON_NULL) @Nullable List<TaskJson> tasks) {

  /**
   * @param task its id
   * @param why a sentence
   */
  record StuckJson(long task, Sentence why) {}

  static OrderJson of(OrderView order) {
    return of(order, order.current().stream().map(TaskJson::of).toList());
  }

  static OrderJson withoutTasks(OrderView order) {
    return of(order, null);
  }

  private static OrderJson of(OrderView order, @Nullable List<TaskJson> tasks) {
    return new OrderJson(
        order.id(),
        order.name(),
        order.kind(),
        order.state(),
        order.parts(),
        order.delivered(),
        order.held(),
        order.createdAt(),
        order.stuck().stream().map(part -> new StuckJson(part.task().id(), part.why())).toList(),
        tasks);
  }
}
