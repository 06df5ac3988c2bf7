package org.toqa.web.input;

import java.util.List;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.web.access.Caller;

/** Who may change an order. */
public final class OrderAccess {
  private OrderAccess() {}

  /** A clerk changes what is all his own as far as it has not ended, an operator everything. */
  public static boolean canChange(Caller caller, OrderView order) {
    List<TaskView> open = order.open();
    return (open.isEmpty() ? order.current() : open)
        .stream().allMatch(task -> caller.mayChangeOrderOf(task.task().owner()));
  }
}
