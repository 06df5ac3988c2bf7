package org.toqa.web.input;

import java.util.List;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.web.access.Caller;

/** Who may change an order. */
public final class OrderAccess {
  private OrderAccess() {}

  /** A clerk changes what is all his own as far as it has not ended, a manager everything. */
  public static boolean canChange(Caller caller, OrderView order) {
    List<TaskView> open = order.open();
    return caller.isManager()
        || (open.isEmpty() ? order.current() : open)
            .stream().allMatch(task -> caller.owns(task.task().owner()));
  }
}
