package org.toqa.network;

import org.jspecify.annotations.Nullable;

/** A device of the network as it is stored. */
public record Device(long id, DeviceOrder order) {

  public String name() {
    return order.name();
  }

  public DeviceKind kind() {
    return order.kind();
  }

  /** Null: not known. */
  public @Nullable HardwareAddress hardware() {
    return order.hardware();
  }

  /** Null: whichever it is given. */
  public @Nullable Ipv4Address address() {
    return order.address();
  }

  /** Whether its address is kept for it: where the DHCP server knows by what. */
  public boolean isReservable() {
    return order.hardware() != null && order.address() != null;
  }
}
