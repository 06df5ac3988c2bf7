package org.toqa.network;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The hardware (MAC) address of one device's network interface.
 *
 * @param text six bytes such as {@code 02:00:5e:10:00:0a}, lower case
 */
public record HardwareAddress(String text) {
  private static final Pattern TEXT = Pattern.compile("[0-9a-f]{2}(:[0-9a-f]{2}){5}");
  private static final String NONE = "00:00:00:00:00:00";

  public HardwareAddress {
    if (!TEXT.matcher(text).matches()) {
      throw new IllegalArgumentException("no hardware address: " + text);
    }
  }

  /**
   * @param text with colons or hyphens, upper or lower case; none of a group (multicast), and not
   *     all zero
   */
  public static Optional<HardwareAddress> parse(String text) {
    String plain = text.toLowerCase(Locale.ROOT).replace('-', ':');
    if (!TEXT.matcher(plain).matches() || plain.equals(NONE)) {
      return Optional.empty();
    }
    boolean isGroup = (Integer.parseInt(plain.substring(0, 2), 16) & 1) == 1;
    return isGroup ? Optional.empty() : Optional.of(new HardwareAddress(plain));
  }

  @Override
  public String toString() {
    return text;
  }
}
