package org.toqa.notices;

import java.net.Inet4Address;
import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Which IP addresses webhooks may lead to: those of the public Internet, and of private networks
 * those that the configuration names. Nobody who may set a webhook makes the server speak to its
 * neighbours thereby (server-side request forgery).
 *
 * @param allowed networks beside the public Internet
 */
public record WebhookAddresses(List<Network> allowed) {

  /** What is no address of the public Internet: the registries of RFC 6890, and multicast. */
  private static final List<Network> NOT_PUBLIC =
      networks(
          "0.0.0.0/8",
          "10.0.0.0/8",
          "100.64.0.0/10",
          "127.0.0.0/8",
          "169.254.0.0/16",
          "172.16.0.0/12",
          "192.0.0.0/24",
          "192.0.2.0/24",
          "192.88.99.0/24",
          "192.168.0.0/16",
          "198.18.0.0/15",
          "198.51.100.0/24",
          "203.0.113.0/24",
          "224.0.0.0/3");

  /** All others of IPv6 are no address of the public Internet. */
  private static final Network PUBLIC_6 = network("2000::/3");

  /** Of those what is for documents, and what leads on to an address of IPv4 or elsewhere. */
  private static final List<Network> NOT_PUBLIC_6 =
      networks("2001::/23", "2001:db8::/32", "2002::/16", "3fff::/20");

  public WebhookAddresses {
    allowed = List.copyOf(allowed);
  }

  /**
   * Addresses with the same first bits.
   *
   * @param bits how many of them
   */
  public record Network(InetAddress first, int bits) {
    private static final int BITS_OF_BYTE = 8;

    /**
     * @param text such as {@code 10.2.0.0/16} or {@code fd00::/8}; without bits one address
     */
    public static Optional<Network> parse(String text) {
      String[] parts = text.strip().split("/", 2);
      try {
        InetAddress first = InetAddress.ofLiteral(parts[0]);
        int all = first.getAddress().length * BITS_OF_BYTE;
        if (parts.length == 1) {
          return Optional.of(new Network(first, all));
        }
        return parts[1].matches("[0-9]{1,3}") && Integer.parseInt(parts[1]) <= all
            ? Optional.of(new Network(first, Integer.parseInt(parts[1])))
            : Optional.empty();
      } catch (IllegalArgumentException e) {
        return Optional.empty();
      }
    }

    boolean contains(InetAddress address) {
      byte[] mine = first.getAddress();
      byte[] other = address.getAddress();
      if (mine.length != other.length) {
        return false;
      }
      for (int bit = 0; bit < bits; bit++) {
        int mask = 0x80 >> (bit % BITS_OF_BYTE);
        if (((mine[bit / BITS_OF_BYTE] ^ other[bit / BITS_OF_BYTE]) & mask) != 0) {
          return false;
        }
      }
      return true;
    }
  }

  private static List<Network> networks(String... texts) {
    return Arrays.stream(texts).map(WebhookAddresses::network).toList();
  }

  private static Network network(String text) {
    return Network.parse(text).orElseThrow();
  }

  /** Whether a webhook may lead there. */
  public boolean allows(InetAddress address) {
    return isPublic(address) || isNamed(address);
  }

  /**
   * Whether it is in a network that the configuration names: there a webhook may be unencrypted.
   */
  public boolean isNamed(InetAddress address) {
    return allowed.stream().anyMatch(network -> network.contains(address));
  }

  /** An IPv4 address in an IPv6 one (::ffff:0:0/96) is one of IPv4 here, as Java has it. */
  private static boolean isPublic(InetAddress address) {
    return switch (address) {
      case Inet4Address four -> NOT_PUBLIC.stream().noneMatch(network -> network.contains(four));
      case Inet6Address six ->
          PUBLIC_6.contains(six)
              && NOT_PUBLIC_6.stream().noneMatch(network -> network.contains(six));
      default -> false;
    };
  }
}
