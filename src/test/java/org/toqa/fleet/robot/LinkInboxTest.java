package org.toqa.fleet.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.wording.Sentence;

class LinkInboxTest {
  private int wakes;
  private final LinkInbox inbox = new LinkInbox(_ -> wakes++);

  @Test
  void ofManyStatesTheNewestWaitsBehindWhatCameBeforeIt() {
    for (int i = 0; i < 100_000; i++) {
      assertTrue(inbox.received(state(i)));
    }
    assertTrue(inbox.received(new Ack(7)));
    assertTrue(inbox.received(state(100_000)));

    assertEquals(List.of(new Ack(7), state(100_000)), takeAll());
    assertEquals(100_000, inbox.takePassedOver().superseded());
    assertEquals(0, inbox.takePassedOver().superseded());
  }

  @Test
  void aFaultThatCameOrWentIsNotPassedOver() {
    List<State> said =
        List.of(state(1), state(2, "HOT"), state(3, "HOT"), state(4), state(5), state(6, "HOT"));
    said.forEach(inbox::received);

    assertEquals(
        List.of(1L, 3L, 5L, 6L), takeAll().stream().map(s -> ((State) s).stamp()).toList());
  }

  @Test
  void beyondWhatMayWaitTheLinkIsToEnd() {
    for (int i = 0; i < LinkInbox.CAPACITY; i++) {
      assertTrue(inbox.received(new Ack(i)));
    }

    assertFalse(inbox.received(new Ack(-1)));
    assertFalse(inbox.received(state(1)));
    assertEquals(2, inbox.takePassedOver().overflows());
    inbox.disconnected(Sentence.verbatim("It says too much."));
    assertEquals(LinkInbox.CAPACITY, takeAll().size());
  }

  @Test
  void theAgentIsWokenOnceUntilItHasTakenSomething() {
    inbox.received(new Ack(1));
    inbox.received(new Ack(2));
    assertEquals(1, wakes);

    inbox.poll();
    inbox.finish();
    assertEquals(2, wakes);
    inbox.poll();
    inbox.finish();
    assertEquals(2, wakes);
    assertNull(inbox.poll());
    inbox.received(new Ack(3));
    assertEquals(3, wakes);
  }

  private List<AgentMessage> takeAll() {
    List<AgentMessage> taken = new ArrayList<>();
    for (RobotMessage next = inbox.poll(); next != null; next = inbox.poll()) {
      if (next instanceof RobotMessage.MessageReceived(AgentMessage message)) {
        taken.add(message);
      }
    }
    return taken;
  }

  static State state(long stamp, String... faults) {
    return new State(
        stamp,
        true,
        new Pose(0.5, 0.5, 0),
        new Speed(0, 0),
        Mode.IDLE,
        null,
        0,
        Role.ALONE,
        0,
        0,
        0,
        0.5,
        List.of(),
        List.of(),
        null,
        null,
        Stream.of(faults).map(code -> new Fault(code, "It is so.")).toList());
  }
}
