package org.toqa.network;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.network.DeviceAnswer.Reason;
import org.toqa.network.DeviceAnswer.Refusal;

/**
 * What an order for a device must not clash with.
 *
 * @param others the other devices
 * @param subnet of the DHCP server; null: there is none
 */
record DeviceRules(
    List<Device> others, List<KnownRobot> robots, List<Lease> leases, @Nullable Subnet subnet) {

  List<Refusal> refusals(DeviceOrder order) {
    List<Refusal> refusals = new ArrayList<>();
    for (Device other : others) {
      if (other.name().equals(order.name())) {
        refusals.add(new Refusal(Reason.NAME_TAKEN, other.name()));
      }
      if (order.hardware() != null && order.hardware().equals(other.hardware())) {
        refusals.add(new Refusal(Reason.HARDWARE_TAKEN, other.name()));
      }
      if (order.address() != null && order.address().equals(other.address())) {
        refusals.add(new Refusal(Reason.ADDRESS_TAKEN, other.name()));
      }
    }
    if (order.address() != null) {
      refuseAddress(order, order.address(), refusals);
    }
    return refusals;
  }

  private void refuseAddress(DeviceOrder order, Ipv4Address address, List<Refusal> refusals) {
    robots.stream()
        .filter(robot -> address.equals(robot.address()))
        .filter(robot -> order.kind() != DeviceKind.ROBOT || !robot.name().equals(order.name()))
        .findFirst()
        .ifPresent(robot -> refusals.add(new Refusal(Reason.ADDRESS_OF_ROBOT, robot.name())));
    if (order.hardware() == null || subnet == null) {
      return; // the DHCP server has no part in it
    }
    if (!subnet.isForDevice(address)) {
      refusals.add(new Refusal(Reason.ADDRESS_OUTSIDE, subnet.toString()));
    }
    leases.stream()
        .filter(lease -> lease.address().equals(address))
        .filter(lease -> !lease.hardware().equals(order.hardware()))
        .findFirst()
        .ifPresent(
            lease -> refusals.add(new Refusal(Reason.ADDRESS_LEASED, lease.hardware().toString())));
  }
}
