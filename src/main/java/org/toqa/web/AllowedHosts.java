package org.toqa.web;

import java.net.InetAddress;
import java.util.Collection;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The names at which browsers find this server. Any other is refused, for with a name of his own,
 * which he lets point to this server afterwards, somebody's page in a browser of this network would
 * be of the same site as ours (DNS rebinding). An IP address and {@code localhost} cannot be made
 * to point elsewhere.
 */
public final class AllowedHosts {
  private final Set<String> names;

  /**
   * @param names host names without a port, in any case
   */
  public AllowedHosts(Collection<String> names) {
    this.names = names.stream().map(AllowedHosts::normal).collect(Collectors.toUnmodifiableSet());
  }

  /**
   * @param host as a request names it, without a port
   */
  public boolean contains(String host) {
    String name = normal(host);
    return name.equals("localhost") || isIpAddress(name) || names.contains(name);
  }

  private static String normal(String host) {
    String lower = host.toLowerCase(Locale.ROOT);
    return lower.endsWith(".") ? lower.substring(0, lower.length() - 1) : lower;
  }

  private static boolean isIpAddress(String name) {
    String literal =
        name.startsWith("[") && name.endsWith("]") ? name.substring(1, name.length() - 1) : name;
    try {
      InetAddress.ofLiteral(literal);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }
}
