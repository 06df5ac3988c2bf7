package org.toqa.accounts;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.HexFormat;

/**
 * The addresses that one subscriber has at will and that count as one: of IPv6 the same first 64
 * bits (RFC 6177), of IPv4 the address itself.
 */
public final class AddressBlock {
  private static final int PREFIX_BYTES = 8;

  private AddressBlock() {}

  /**
   * @param address an IP address; what is none counts as itself
   */
  public static String of(String address) {
    try {
      return InetAddress.ofLiteral(address.replaceFirst("%.*", "")) instanceof Inet6Address six
          ? HexFormat.of().formatHex(six.getAddress(), 0, PREFIX_BYTES) + "/64"
          : address;
    } catch (IllegalArgumentException e) {
      return address;
    }
  }
}
