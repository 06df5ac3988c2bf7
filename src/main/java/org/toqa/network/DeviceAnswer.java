package org.toqa.network;

import java.util.List;

/** What became of an order for a device. */
public sealed interface DeviceAnswer {

  /** It is stored, and the DHCP server is told. */
  record Stored(Device device) implements DeviceAnswer {}

  /** Nothing was changed. */
  record Refused(List<Refusal> refusals) implements DeviceAnswer {
    public Refused {
      refusals = List.copyOf(refusals);
    }
  }

  /** There is no such device. */
  record Unknown() implements DeviceAnswer {}

  /**
   * Why not.
   *
   * @param with the device, robot, subnet or number that it clashes with
   */
  record Refusal(Reason reason, String with) {}

  /** Why an order is refused. */
  enum Reason {
    NAME_TAKEN,
    HARDWARE_TAKEN,
    ADDRESS_TAKEN,
    /** A robot of the fleet, of another name, is asked there. */
    ADDRESS_OF_ROBOT,
    ADDRESS_OF_SERVER,
    /** To be served by the DHCP server, and not in its subnet. */
    ADDRESS_OUTSIDE,
    /** The DHCP server gave it to another device, which still has it. */
    ADDRESS_LEASED,
    TOO_MANY
  }
}
