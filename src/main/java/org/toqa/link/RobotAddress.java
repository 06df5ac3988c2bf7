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
 * @param gateway the name of the gateway that reaches it, in whose network {@code host} is; null:
 *     the server does
 */
public record RobotAddress(
    String robot,
    String host,
    int port,
    @Nullable Fingerprint fingerprint,
    @Nullable String gateway) {

  /** Of a robot that the server reaches itself. */
  public RobotAddress(String robot, String host, int port, @Nullable Fingerprint fingerprint) {
    this(robot, host, port, fingerprint, null);
  }

  /** The same robot at another port. */
  public RobotAddress withPort(int other) {
    return new RobotAddress(robot, host, other, fingerprint, gateway);
  }

  /** For sentences, with the gateway. */
  String place() {
    String hostAndPort = host + ":" + port;
    return gateway == null ? hostAndPort : gateway + "/" + hostAndPort;
  }
}
