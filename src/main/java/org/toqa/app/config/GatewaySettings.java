package org.toqa.app.config;

import java.net.InetAddress;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.toqa.link.trust.Fingerprint;

/**
 * Where this server listens for gateways, and for which.
 *
 * @param port TCP port; 0: any free one
 * @param trusted by their names, in the order in which they are shown; at least one
 */
public record GatewaySettings(InetAddress address, int port, Map<String, Fingerprint> trusted) {

  static final String DESCRIPTION =
      "names of gateways with their fingerprints and commas between, such as dock=9f86...0a08";

  private static final String NAME = "[A-Za-z0-9][A-Za-z0-9._-]{0,63}";

  public GatewaySettings {
    trusted = Collections.unmodifiableMap(new LinkedHashMap<>(trusted));
  }

  /** Empty where it is not {@link #DESCRIPTION}, or has a name or a fingerprint twice. */
  static Optional<Map<String, Fingerprint>> parseTrusted(String text) {
    Map<String, Fingerprint> trusted = new LinkedHashMap<>();
    for (String entry : text.split(",", -1)) {
      String[] parts = entry.split("=", -1);
      Optional<Fingerprint> fingerprint =
          parts.length == 2 ? Fingerprint.parse(parts[1].strip()) : Optional.empty();
      if (fingerprint.isEmpty()
          || !parts[0].strip().matches(NAME)
          || trusted.containsValue(fingerprint.get())
          || trusted.put(parts[0].strip(), fingerprint.get()) != null) {
        return Optional.empty();
      }
    }
    return Optional.of(trusted);
  }
}
