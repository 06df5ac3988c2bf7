package org.toqa.network;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A line of the list of devices.
 *
 * @param device as it is stored; null: it is not, but a robot of the fleet, or somebody with a
 *     lease
 * @param isRobot whether the fleet has a robot of that name
 * @param name null: it does not say any
 * @param kind null: not known
 * @param address where it is asked, or what it has or shall have; null: not known
 * @param hardware null: not known
 * @param lease that it has now; null: none
 * @param reachable null: not tried yet, or its address is not known
 * @param heardAt null: never
 */
public record NetworkEntry(
    @Nullable Device device,
    boolean isRobot,
    @Nullable String name,
    @Nullable DeviceKind kind,
    @Nullable String address,
    @Nullable HardwareAddress hardware,
    @Nullable Lease lease,
    @Nullable Boolean reachable,
    @Nullable Instant heardAt) {

  /** Nobody has said yet what it is. */
  public boolean isUnknown() {
    return kind == null;
  }

  /** The other address that it has by now, until it asks again; null: it has the right one. */
  public @Nullable Ipv4Address otherAddress() {
    if (lease == null || device == null || device.address() == null) {
      return null;
    }
    return lease.address().equals(device.address()) ? null : lease.address();
  }

  /** What is reserved for a robot that the fleet asks elsewhere; null: it asks there. */
  public @Nullable Ipv4Address reservedElsewhere() {
    if (!isRobot || device == null || device.address() == null) {
      return null;
    }
    return device.address().toString().equals(address) ? null : device.address();
  }
}
