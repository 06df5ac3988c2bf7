package org.toqa.web.input;

import java.util.List;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.web.Orders;
import org.toqa.web.Services;
import org.toqa.web.access.Caller;

/** Who may change an order, and what is told for him at once. */
public final class OrderAccess {
  private OrderAccess() {}

  /** A clerk changes what is all his own as far as it has not ended, an operator everything. */
  public static boolean canChange(Caller caller, OrderView order) {
    List<TaskView> open = order.open();
    return (open.isEmpty() ? order.current() : open)
        .stream().allMatch(task -> caller.mayChangeOrderOf(task.task().owner()));
  }

  /**
   * Tells what robots stop for to what the fleet has of an order, where the caller may change that.
   *
   * @see Orders#tellAtOnce
   */
  public static void tellAtOnce(
      Services services, Caller caller, long order, MissionEvent.OperatorCommand command) {
    new Orders(services).tellAtOnce(order, there -> canChange(caller, there), command);
  }
}
