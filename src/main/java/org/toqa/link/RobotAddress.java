package org.toqa.link;

import org.jspecify.annotations.Nullable;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;

/**
 * Where a robot is, and how it is known.
 *
 * @param robot the name that it must say in its hello
 * @param port of TCP, 1 to 65535
 * @param fingerprint of the certificate that it must show; null: the link is not encrypted, of a
 *     robot that was never paired
 * @param gateway the name of the gateway that reaches it, in whose network {@code host} is; null:
 *     the server does
 * @param token that it wants of the server, over HTTP; null: it speaks the robot link
 */
public record RobotAddress(
    String robot,
    String host,
    int port,
    @Nullable Fingerprint fingerprint,
    @Nullable String gateway,
    @Nullable RobotToken token) {

  /** Of a robot that speaks the robot link. */
  public RobotAddress(
      String robot,
      String host,
      int port,
      @Nullable Fingerprint fingerprint,
      @Nullable String gateway) {
    this(robot, host, port, fingerprint, gateway, null);
  }

  /** The same of one that the server reaches itself. */
  public RobotAddress(String robot, String host, int port, @Nullable Fingerprint fingerprint) {
    this(robot, host, port, fingerprint, null);
  }

  /** The same robot at another port. */
  public RobotAddress withPort(int other) {
    return new RobotAddress(robot, host, other, fingerprint, gateway, token);
  }

  /** For sentences, with the gateway. */
  public String place() {
    String hostAndPort = host + ":" + port;
    return gateway == null ? hostAndPort : gateway + "/" + hostAndPort;
  }
}
