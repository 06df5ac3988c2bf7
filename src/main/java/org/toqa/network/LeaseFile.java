package org.toqa.network;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Reads dnsmasq's leases: a line each, with the second of its end since 1970 (0: none), hardware
 * address, IP address, the host's name ({@code *}: none) and its client identifier. Lines of IPv6
 * and of other hardware than Ethernet and Wi-Fi are passed over.
 */
final class LeaseFile {
  private static final Pattern SECONDS = Pattern.compile("[0-9]{1,11}");
  private static final Pattern HOST_NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,63}");
  private static final int FIELDS = 4;

  private LeaseFile() {}

  /** Those that have not ended. */
  static List<Lease> parse(String text, Instant now) {
    return text.lines()
        .flatMap(line -> lease(Arrays.asList(line.strip().split(" +", -1))).stream())
        .filter(lease -> lease.until() == null || lease.until().isAfter(now))
        .toList();
  }

  private static Optional<Lease> lease(List<String> fields) {
    if (fields.size() < FIELDS || !SECONDS.matcher(fields.getFirst()).matches()) {
      return Optional.empty();
    }
    long until = Long.parseLong(fields.getFirst());
    Optional<Ipv4Address> address = Ipv4Address.parse(fields.get(2));
    return HardwareAddress.parse(fields.get(1))
        .filter(hardware -> address.isPresent())
        .map(
            hardware ->
                new Lease(
                    hardware,
                    address.get(),
                    until == 0 ? null : Instant.ofEpochSecond(until),
                    hostName(fields.get(3))));
  }

  private static @Nullable String hostName(String given) {
    return HOST_NAME.matcher(given).matches() ? given : null;
  }
}
