package org.toqa.network;

import java.util.Optional;

/**
 * Addresses with the same first bits.
 *
 * @param first the address whose other bits are 0
 * @param bits how many are the same, 8 to 30
 */
public record Subnet(Ipv4Address first, int bits) {
  private static final int FEWEST_BITS = 8;
  private static final int MOST_BITS = 30;

  /**
   * @param text such as {@code 10.0.7.0/24}; the address is the first one of the subnet
   */
  public static Optional<Subnet> parse(String text) {
    String[] parts = text.split("/", 2);
    if (parts.length < 2 || !parts[1].matches("[0-9]{1,2}")) {
      return Optional.empty();
    }
    int bits = Integer.parseInt(parts[1]);
    return Ipv4Address.parse(parts[0])
        .filter(first -> bits >= FEWEST_BITS && bits <= MOST_BITS)
        .map(first -> new Subnet(first, bits))
        .filter(subnet -> (subnet.first.bits() & ~subnet.mask()) == 0);
  }

  private int mask() {
    return -1 << (32 - bits);
  }

  private boolean contains(Ipv4Address address) {
    return (address.bits() & mask()) == first.bits();
  }

  /**
   * Whether a device may have it: it is in the subnet, and neither its own nor the broadcast one.
   */
  public boolean isForDevice(Ipv4Address address) {
    int rest = address.bits() & ~mask();
    return contains(address) && rest != 0 && rest != ~mask();
  }

  @Override
  public String toString() {
    return first + "/" + bits;
  }
}
