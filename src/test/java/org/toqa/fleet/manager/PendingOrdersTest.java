package org.toqa.fleet.manager;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;
import org.toqa.fleet.Answer;
import org.toqa.wording.Sentence;

class PendingOrdersTest {
  private final PendingOrders orders = new PendingOrders();

  @Test
  void whoseCheckEndsFirstWaitsForWhoCameFirst() {
    ManagerMessage.OrderChecked first = checked();
    ManagerMessage.OrderChecked second = checked();

    orders.setResult(second);
    assertNull(orders.pollChecked());

    orders.setResult(first);
    assertSame(first, orders.pollChecked());
    assertSame(second, orders.pollChecked());
    assertNull(orders.pollChecked());
  }

  private ManagerMessage.OrderChecked checked() {
    return new ManagerMessage.OrderChecked(
        orders.add(null, 0), new Answer.Unknown<>(Sentence.verbatim("No.")), null);
  }
}
