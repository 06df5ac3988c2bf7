package org.toqa.link;

import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.Fingerprint;

/**
 * Where a robot is, and how it is known.
 *
 * @param robot the name that it must say in its hello
 * @param port of TCP, 1 to 65535
 * @param fingerprint of the certificate that it must show; null: it was never paired, and the link
 *     is not encrypted
 */
public record RobotAddress(String robot, String host, int port, @Nullable Fingerprint fingerprint) {

  String hostAndPort() {
    return host + ":" + port;
  }
}
