package org.toqa.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.network.DeviceAnswer.Reason;
import org.toqa.network.DeviceAnswer.Refusal;

/** What is known of devices, brought together; and what clashes. */
class NetworkListTest {
  private static final Instant NOW = Instant.parse("2026-11-27T12:00:00Z");
  private static final HardwareAddress A = new HardwareAddress("02:00:00:00:00:0a");
  private static final HardwareAddress B = new HardwareAddress("02:00:00:00:00:0b");
  private static final Subnet SUBNET = Subnet.parse("10.0.7.0/24").orElseThrow();

  private static Ipv4Address ip(String text) {
    return Ipv4Address.parse(text).orElseThrow();
  }

  private static Lease lease(HardwareAddress hardware, String address) {
    return new Lease(hardware, ip(address), NOW.plusSeconds(60), "host");
  }

  private static KnownRobot robot(String name, String address) {
    return new KnownRobot(name, address, ip(address), true, NOW);
  }

  private static Device device(long id, String name, DeviceKind kind, String address) {
    return new Device(id, new DeviceOrder(name, kind, A, ip(address)));
  }

  private static List<NetworkEntry> entries(
      List<KnownRobot> robots, List<Device> devices, List<Lease> leases) {
    return new NetworkList(robots, devices, leases, Map.of(), Map.of()).entries();
  }

  @Test
  void leasesOfDnsmasqAreRead() {
    String file =
        """
        1795780860 02:00:00:00:00:0a 10.0.7.110 spare 01:02:00:00:00:00:0a
        1795780799 02:00:00:00:00:0b 10.0.7.111 ended *
        0 02:00:00:00:00:0b 10.0.7.112 * *
        1795780860 06-02:00:00:00:00:0b 10.0.7.113 other-hardware *
        duid 00:01:00:01:2f:aa:bb:cc
        1795780860 33554442 fd00::7:10 spare 00:01
        1795780860 02:00:00:00:00:0a 10.0.7.114 <script> *
        nonsense
        """;

    assertEquals(
        List.of(
            new Lease(A, ip("10.0.7.110"), Instant.ofEpochSecond(1_795_780_860L), "spare"),
            new Lease(B, ip("10.0.7.112"), null, null),
            new Lease(A, ip("10.0.7.114"), Instant.ofEpochSecond(1_795_780_860L), null)),
        LeaseFile.parse(file, Instant.ofEpochSecond(1_795_780_800L)));
  }

  @Test
  void reservationsHaveAddressesOnly() {
    Device camera = device(1, "12h", DeviceKind.CAMERA, "10.0.7.20");
    Device seen = new Device(2, new DeviceOrder("ap", DeviceKind.ACCESS_POINT, B, null));

    assertEquals(
        List.of("02:00:00:00:00:0a,10.0.7.20"),
        Dnsmasq.reservations(List.of(camera, seen)).lines().skip(1).toList());
  }

  @Test
  void neighboursWhoAnsweredAreRead() {
    String table =
        """
        IP address       HW type     Flags       HW address            Mask     Device
        10.0.7.110       0x1         0x2         02:00:00:00:00:0a     *        eth0
        10.0.7.111       0x1         0x0         00:00:00:00:00:00     *        eth0
        """;

    assertEquals(Map.of(ip("10.0.7.110"), A), NeighbourTable.parse(table));
  }

  @Test
  void robotIsListedOnceWithItsReservationAndLease() {
    List<NetworkEntry> entries =
        entries(
            List.of(robot("r1", "10.0.7.20")),
            List.of(device(1, "r1", DeviceKind.ROBOT, "10.0.7.20")),
            List.of(lease(A, "10.0.7.110")));

    assertEquals(1, entries.size());
    NetworkEntry entry = entries.getFirst();
    assertTrue(entry.isRobot());
    assertEquals(A, entry.hardware());
    assertEquals(ip("10.0.7.110"), entry.otherAddress(), "until it asks again");
    assertNull(entry.reservedElsewhere());
  }

  @Test
  void robotThatIsAskedElsewhereThanIsReservedIsToldSo() {
    NetworkEntry entry =
        entries(
                List.of(robot("r1", "10.0.7.110")),
                List.of(device(1, "r1", DeviceKind.ROBOT, "10.0.7.20")),
                List.of())
            .getFirst();

    assertEquals(ip("10.0.7.20"), entry.reservedElsewhere());
  }

  @Test
  void robotWithoutReservationIsKnownByItsLease() {
    NetworkEntry entry =
        entries(List.of(robot("r1", "10.0.7.110")), List.of(), List.of(lease(B, "10.0.7.110")))
            .getFirst();

    assertEquals(B, entry.hardware());
    assertFalse(entry.isUnknown());
  }

  @Test
  void whoeverHasALeaseBesidesIsUnknown() {
    List<NetworkEntry> entries =
        entries(List.of(robot("r1", "10.0.7.20")), List.of(), List.of(lease(B, "10.0.7.110")));

    assertEquals(2, entries.size());
    assertTrue(entries.getLast().isUnknown());
    assertEquals("host", entries.getLast().name());
  }

  @Test
  void contactIsOfTheAddressThatTheDeviceHasNow() {
    NetworkList list =
        new NetworkList(
            List.of(),
            List.of(device(1, "gate", DeviceKind.CAMERA, "10.0.7.20")),
            List.of(lease(A, "10.0.7.110")),
            Map.of(),
            Map.of(
                ip("10.0.7.20"), new Contact(false, null),
                ip("10.0.7.110"), new Contact(true, NOW)));

    assertEquals(true, list.entries().getFirst().reachable());
    assertEquals("10.0.7.20", list.entries().getFirst().address());
  }

  @Test
  void clashesAreNamed() {
    Device camera = device(1, "gate", DeviceKind.CAMERA, "10.0.7.20");
    DeviceRules rules =
        new DeviceRules(
            List.of(camera),
            List.of(robot("r1", "10.0.7.30")),
            List.of(lease(B, "10.0.7.110")),
            SUBNET);

    assertEquals(
        List.of(
            new Refusal(Reason.NAME_TAKEN, "gate"),
            new Refusal(Reason.HARDWARE_TAKEN, "gate"),
            new Refusal(Reason.ADDRESS_TAKEN, "gate")),
        rules.refusals(camera.order()));
    assertEquals(
        List.of(new Refusal(Reason.ADDRESS_LEASED, B.text())),
        rules.refusals(order("new", DeviceKind.CAMERA, "10.0.7.110")));
    assertEquals(
        List.of(new Refusal(Reason.ADDRESS_OUTSIDE, "10.0.7.0/24")),
        rules.refusals(order("new", DeviceKind.CAMERA, "10.0.8.1")));
    assertEquals(
        List.of(new Refusal(Reason.ADDRESS_OF_ROBOT, "r1")),
        rules.refusals(order("new", DeviceKind.CAMERA, "10.0.7.30")));
    assertEquals(List.of(), rules.refusals(order("r1", DeviceKind.ROBOT, "10.0.7.30")));
    assertEquals(List.of(), rules.refusals(order("new", DeviceKind.CAMERA, "10.0.7.40")));
  }

  private static DeviceOrder order(String name, DeviceKind kind, String address) {
    return new DeviceOrder(name, kind, new HardwareAddress("02:00:00:00:00:0c"), ip(address));
  }
}
