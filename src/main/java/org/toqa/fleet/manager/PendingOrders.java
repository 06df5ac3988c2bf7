package org.toqa.fleet.manager;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/**
 * Submitted orders whose checks are running: whichever check ends first, they go on in the order in
 * which they came. Confined to one agent.
 */
final class PendingOrders {
  private final Deque<Pending> inOrder = new ArrayDeque<>();

  /** An order, and what its check has said once it has ended. */
  static final class Pending {
    private final ManagerMessage.SubmitTask request;
    private ManagerMessage.@Nullable OrderChecked result;

    private Pending(ManagerMessage.SubmitTask request) {
      this.request = request;
    }

    ManagerMessage.SubmitTask request() {
      return request;
    }
  }

  Pending add(ManagerMessage.SubmitTask request) {
    Pending pending = new Pending(request);
    inOrder.addLast(pending);
    return pending;
  }

  void setResult(ManagerMessage.OrderChecked checked) {
    checked.order().result = checked;
  }

  /** The order that came first, if it has been checked, goes out; null where it has not. */
  ManagerMessage.@Nullable OrderChecked pollChecked() {
    Pending first = inOrder.peekFirst();
    if (first == null || first.result == null) {
      return null;
    }
    inOrder.removeFirst();
    return first.result;
  }
}
