package org.toqa.network;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Brings together what is known of each device: robots of the fleet, then what was said of other
 * devices, then who has a lease besides.
 *
 * @param neighbours who answered at which address
 * @param contacts by address
 */
record NetworkList(
    List<KnownRobot> robots,
    List<Device> devices,
    List<Lease> leases,
    Map<Ipv4Address, HardwareAddress> neighbours,
    Map<Ipv4Address, Contact> contacts) {

  List<NetworkEntry> entries() {
    List<NetworkEntry> entries = new ArrayList<>();
    robots.forEach(robot -> entries.add(entry(robot)));
    Set<String> listed = new HashSet<>();
    robots.forEach(robot -> listed.add(robot.name()));
    devices.stream()
        .filter(device -> device.kind() != DeviceKind.ROBOT || !listed.contains(device.name()))
        .forEach(device -> entries.add(entry(device)));
    Set<Lease> told = new HashSet<>();
    entries.forEach(
        entry -> {
          if (entry.lease() != null) {
            told.add(entry.lease());
          }
        });
    leases.stream()
        .filter(lease -> !told.contains(lease))
        .forEach(lease -> entries.add(entry(lease)));
    return entries;
  }

  private NetworkEntry entry(KnownRobot robot) {
    Optional<Device> device =
        devices.stream()
            .filter(d -> d.kind() == DeviceKind.ROBOT && d.name().equals(robot.name()))
            .findFirst();
    HardwareAddress said = device.map(Device::hardware).orElse(null);
    Optional<Lease> lease = lease(said, robot.address());
    return new NetworkEntry(
        device.orElse(null),
        true,
        robot.name(),
        DeviceKind.ROBOT,
        robot.place(),
        hardware(said, lease, robot.address()),
        lease.orElse(null),
        robot.reachable(),
        robot.heardAt());
  }

  private NetworkEntry entry(Device device) {
    Optional<Lease> lease = lease(device.hardware(), device.address());
    Ipv4Address present = lease.map(Lease::address).orElse(device.address());
    Ipv4Address shown = device.address() == null ? present : device.address();
    Contact contact = present == null ? null : contacts.get(present);
    return new NetworkEntry(
        device,
        false,
        device.name(),
        device.kind(),
        shown == null ? null : shown.toString(),
        hardware(device.hardware(), lease, present),
        lease.orElse(null),
        contact == null ? null : contact.reachable(),
        contact == null ? null : contact.heardAt());
  }

  private NetworkEntry entry(Lease lease) {
    Contact contact = contacts.get(lease.address());
    return new NetworkEntry(
        null,
        false,
        lease.hostName(),
        null,
        lease.address().toString(),
        lease.hardware(),
        lease,
        contact == null ? null : contact.reachable(),
        contact == null ? null : contact.heardAt());
  }

  /** By its hardware where that is known: who has its address meanwhile is somebody else. */
  private Optional<Lease> lease(@Nullable HardwareAddress hardware, @Nullable Ipv4Address address) {
    return leases.stream()
        .filter(
            lease ->
                hardware == null
                    ? lease.address().equals(address)
                    : lease.hardware().equals(hardware))
        .findFirst();
  }

  private @Nullable HardwareAddress hardware(
      @Nullable HardwareAddress said, Optional<Lease> lease, @Nullable Ipv4Address address) {
    if (said != null) {
      return said;
    }
    return lease
        .map(Lease::hardware)
        .orElseGet(() -> address == null ? null : neighbours.get(address));
  }

  /** Whom to ask whether they answer: all but robots, which the fleet asks. */
  Set<Ipv4Address> toAsk() {
    Set<Ipv4Address> addresses = new HashSet<>();
    Stream.concat(
            devices.stream().map(Device::address).filter(Objects::nonNull),
            leases.stream().map(Lease::address))
        .forEach(addresses::add);
    return addresses;
  }
}
