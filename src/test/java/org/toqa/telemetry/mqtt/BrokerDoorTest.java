package org.toqa.telemetry.mqtt;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetAddress;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class BrokerDoorTest {
  private final Set<String> waiting = new HashSet<>();
  private final BrokerDoor door = new BrokerDoor(5, 2, block -> !waiting.contains(block));

  private boolean enter(String address) {
    return door.tryEnter(InetAddress.ofLiteral(address));
  }

  private void assertFull(String address) {
    assertFalse(enter(address), address);
  }

  @Test
  void oneAddressHasSoManyPlaces() {
    assertTrue(enter("192.0.2.1"));
    assertTrue(enter("192.0.2.1"));
    assertFull("192.0.2.1");
    assertTrue(enter("192.0.2.2"));

    door.leave(InetAddress.ofLiteral("192.0.2.1"));
    assertTrue(enter("192.0.2.1"));
    assertFull("192.0.2.1");
  }

  @Test
  void addressesOfOneSubscriberAreOne() {
    assertTrue(enter("2001:db8:0:1::1"));
    assertTrue(enter("2001:db8:0:1::2"));
    assertFull("2001:db8:0:1:ffff::3");
    assertTrue(enter("2001:db8:0:2::1"));
  }

  @Test
  void whoTriesTooOftenWaitsThoughThereIsAPlace() {
    waiting.add("192.0.2.1");
    waiting.add("127.0.0.1");

    assertFull("192.0.2.1");
    assertTrue(enter("192.0.2.2"));
    assertTrue(enter("127.0.0.1"), "the server itself");
  }

  @Test
  void strangersLeaveThisMachinesOwnAPlace() {
    for (int i = 1; i <= 5; i++) {
      assertTrue(enter("192.0.2." + i));
    }
    assertFull("192.0.2.6");

    for (int i = 0; i < BrokerDoor.RESERVE; i++) {
      assertTrue(enter(i % 2 == 0 ? "127.0.0.1" : "::1"));
    }
    assertFull("127.0.0.1");
    assertFull("192.0.2.6");
  }
}
