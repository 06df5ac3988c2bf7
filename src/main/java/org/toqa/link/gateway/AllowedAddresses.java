package org.toqa.link.gateway;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Where a gateway may connect to. */
public final class AllowedAddresses {

  /** Of a robot's daemon, unless it is configured otherwise. */
  private static final int USUAL_PORT = 7275;

  private static final Pattern WITH_PORT =
      Pattern.compile("(?:\\[([0-9A-Fa-f:.]+)]|([^:\\[\\]]+)):([1-9][0-9]{0,4})");
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9_-][A-Za-z0-9._-]{0,252}");

  private final List<Rule> rules;

  /**
   * @param name a host by its name; null: {@code network} counts
   * @param bits so many of the network's address count
   */
  private record Rule(@Nullable String name, @Nullable InetAddress network, int bits, int port) {

    boolean allows(String host, InetAddress address, int wanted) {
      return wanted == port
          && (network == null ? host.equalsIgnoreCase(name) : contains(network, address));
    }

    private boolean contains(InetAddress own, InetAddress address) {
      byte[] a = own.getAddress();
      byte[] b = address.getAddress();
      int whole = bits / 8;
      int rest = 0xff00 >> bits % 8 & 0xff; // of the next byte
      return a.length == b.length
          && Arrays.equals(a, 0, whole, b, 0, whole)
          && (rest == 0 || (a[whole] & rest) == (b[whole] & rest));
    }
  }

  private AllowedAddresses(List<Rule> rules) {
    this.rules = rules;
  }

  /**
   * @param texts each a host's name, an IP address or a block of them such as 192.168.7.0/24, with
   *     or without a port
   * @throws IllegalArgumentException with the first text that is none of these
   */
  public static AllowedAddresses of(List<String> texts) {
    return new AllowedAddresses(texts.stream().map(AllowedAddresses::rule).toList());
  }

  private static Rule rule(String text) {
    Matcher withPort = WITH_PORT.matcher(text);
    boolean hasPort = withPort.matches();
    int port = hasPort ? Integer.parseInt(withPort.group(3)) : USUAL_PORT;
    String host = text;
    if (hasPort) {
      host = withPort.group(1) == null ? withPort.group(2) : withPort.group(1);
    }
    if (port > 65_535) {
      throw new IllegalArgumentException(text);
    }
    String[] parts = host.split("/", -1);
    if (parts[0].matches("[0-9.]+") && !parts[0].matches("([0-9]+[.]){3}[0-9]+")) {
      throw new IllegalArgumentException(text); // 192.168.7 would be 192.168.0.7
    }
    try {
      InetAddress network = InetAddress.ofLiteral(parts[0]);
      int all = network.getAddress().length * 8;
      int bits = parts.length == 1 ? all : Integer.parseInt(parts[1]);
      if (parts.length > 2 || bits < 0 || bits > all) {
        throw new IllegalArgumentException(text);
      }
      return new Rule(null, network, bits, port);
    } catch (IllegalArgumentException e) {
      if (!NAME.matcher(host).matches() || host.matches("[0-9.]+")) {
        throw new IllegalArgumentException(text, e);
      }
      return new Rule(host, null, 0, port);
    }
  }

  /**
   * The address of a host, if it may be connected to; asks the network for it.
   *
   * @throws UnknownHostException nobody knows the host
   */
  Optional<InetAddress> find(String host, int port) throws UnknownHostException {
    for (InetAddress address : InetAddress.getAllByName(host)) {
      if (rules.stream().anyMatch(rule -> rule.allows(host, address, port))) {
        return Optional.of(address);
      }
    }
    return Optional.empty();
  }
}
