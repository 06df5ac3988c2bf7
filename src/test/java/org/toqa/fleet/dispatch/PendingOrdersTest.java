package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.UUID;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.apache.pekko.pattern.StatusReply;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.wording.Sentence;

class PendingOrdersTest {
  private static final TaskOrder ORDER =
      new TaskOrder("box", 1, new Where.Station("A"), new Where.Station("B"), null, 0, null, null);

  private final ActorSystem<StatusReply<Answer<TaskView>>> caller =
      ActorSystem.create(Behaviors.ignore(), "caller");
  private final PendingOrders orders = new PendingOrders();

  @AfterEach
  void stop() {
    caller.terminate();
  }

  @Test
  void nobodyWaitsForTheCheckOfAnotherUsersOrder() {
    checked("Clara");
    DispatchMessage.OrderChecked other = checked("Max");

    orders.setResult(other);

    assertSame(other, orders.pollChecked("Max"));
    assertNull(orders.pollChecked("Clara"));
  }

  @Test
  void whoseCheckEndsFirstWaitsForWhoCameFirst() {
    DispatchMessage.OrderChecked first = checked("Clara");
    DispatchMessage.OrderChecked second = checked("Clara");

    orders.setResult(second);
    assertNull(orders.pollChecked("Clara"));

    orders.setResult(first);
    assertSame(first, orders.pollChecked("Clara"));
    assertSame(second, orders.pollChecked("Clara"));
    assertNull(orders.pollChecked("Clara"));
  }

  private DispatchMessage.OrderChecked checked(String user) {
    DispatchMessage.SubmitTask request =
        new DispatchMessage.SubmitTask(
            ORDER,
            Orderer.named(user),
            UUID.randomUUID(),
            0,
            new OrderChecks(Runnable::run, 1, System::nanoTime).begin(user),
            caller);
    return new DispatchMessage.OrderChecked(
        orders.add(request), new Answer.Unknown<>(Sentence.verbatim("No.")), null);
  }
}
