package org.toqa.network;

import java.net.InetAddress;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * An IPv4 address.
 *
 * @param bits the first number of its text in the highest eight bits
 */
public record Ipv4Address(int bits) implements Comparable<Ipv4Address> {
  private static final Pattern TEXT =
      Pattern.compile("(\\d{1,3})\\.(\\d{1,3})\\.(\\d{1,3})\\.(\\d{1,3})");
  private static final int LARGEST_PART = 255;
  private static final int LOOPBACK = 127;
  private static final int FIRST_OF_GROUPS = 224;

  /**
   * @param text four numbers such as {@code 10.0.7.20}; no shorter form, and no leading zeros,
   *     which some programs read as octal
   */
  public static Optional<Ipv4Address> parse(String text) {
    Matcher parts = TEXT.matcher(text);
    if (!parts.matches()) {
      return Optional.empty();
    }
    int bits = 0;
    for (int part = 1; part <= 4; part++) {
      String digits = parts.group(part);
      int value = Integer.parseInt(digits);
      if (value > LARGEST_PART || (digits.length() > 1 && digits.startsWith("0"))) {
        return Optional.empty();
      }
      bits = bits << 8 | value;
    }
    return Optional.of(new Ipv4Address(bits));
  }

  /** Whether a device of a network may have it: it is none of loopback, of groups or of nobody. */
  public boolean isOfDevice() {
    int part = bits >>> 24;
    return part != 0 && part != LOOPBACK && part < FIRST_OF_GROUPS;
  }

  /** For sockets. */
  InetAddress toInetAddress() {
    return InetAddress.ofLiteral(toString());
  }

  @Override
  public int compareTo(Ipv4Address other) {
    return Integer.compareUnsigned(bits, other.bits);
  }

  @Override
  public String toString() {
    return "%d.%d.%d.%d".formatted(bits >>> 24, bits >>> 16 & 255, bits >>> 8 & 255, bits & 255);
  }
}
