package org.toqa.fleet.dispatch;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Submitted orders whose checks are running: whichever check ends first, those of one user go on in
 * the order in which they came, and wait for no other user's. Confined to one agent.
 */
final class PendingOrders {
  private final Map<String, Deque<Pending>> byUser = new HashMap<>();

  /** An order, and what its check has said once it has ended. */
  static final class Pending {
    private final DispatchMessage.SubmitTask request;
    private DispatchMessage.@Nullable OrderChecked result;

    private Pending(DispatchMessage.SubmitTask request) {
      this.request = request;
    }

    DispatchMessage.SubmitTask request() {
      return request;
    }
  }

  Pending add(DispatchMessage.SubmitTask request) {
    Pending pending = new Pending(request);
    byUser.computeIfAbsent(request.by().name(), _ -> new ArrayDeque<>()).addLast(pending);
    return pending;
  }

  void setResult(DispatchMessage.OrderChecked checked) {
    checked.order().result = checked;
  }

  /** The user's order that came first, if it has been checked, goes out; null where it has not. */
  DispatchMessage.@Nullable OrderChecked pollChecked(String user) {
    Deque<Pending> inOrder = byUser.get(user);
    Pending first = inOrder == null ? null : inOrder.peekFirst();
    if (inOrder == null || first == null || first.result == null) {
      return null;
    }
    inOrder.removeFirst();
    if (inOrder.isEmpty()) {
      byUser.remove(user);
    }
    return first.result;
  }
}
