package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;

/**
 * An order for another address, strength or parking point of a robot.
 *
 * @param maxLoad kilograms
 * @param parking a parking point's name; null: it stays where its last task ends
 * @param gateway that reaches it; null: the server does
 * @param token that it wants of the server from now on, over HTTP; null: as before
 * @param fingerprint of the certificate that it shows from now on, over HTTP; null: as before
 */
public record RobotChange(
    String host,
    int port,
    double maxLoad,
    @Nullable String parking,
    @Nullable String gateway,
    @Nullable RobotToken token,
    @Nullable Fingerprint fingerprint) {

  /** With token and certificate as before. */
  public RobotChange(
      String host, int port, double maxLoad, @Nullable String parking, @Nullable String gateway) {
    this(host, port, maxLoad, parking, gateway, null, null);
  }

  /** Of a robot that the server reaches itself. */
  public RobotChange(String host, int port, double maxLoad, @Nullable String parking) {
    this(host, port, maxLoad, parking, null);
  }
}
