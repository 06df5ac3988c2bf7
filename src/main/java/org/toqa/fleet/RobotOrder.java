package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;

/**
 * An order for a new robot.
 *
 * @param maxLoad kilograms
 * @param parking a parking point's name; null: the first that no robot has
 * @param code that the robot shows; null: it is not paired
 * @param gateway that reaches it; null: the server does
 * @param floor where it is; null: on the first
 * @param http of a robot that takes wheel commands over HTTP; null: it speaks the robot link
 */
public record RobotOrder(
    String name,
    String host,
    int port,
    double maxLoad,
    @Nullable String parking,
    @Nullable PairingCode code,
    @Nullable String gateway,
    @Nullable String floor,
    @Nullable HttpAccess http) {

  /**
   * How server and robot know each other over HTTP.
   *
   * @param token that the robot wants
   * @param fingerprint of its certificate; null: it does not encrypt
   */
  public record HttpAccess(RobotToken token, @Nullable Fingerprint fingerprint) {}

  /** For a robot of the first floor. */
  public RobotOrder(
      String name,
      String host,
      int port,
      double maxLoad,
      @Nullable String parking,
      @Nullable PairingCode code,
      @Nullable String gateway) {
    this(name, host, port, maxLoad, parking, code, gateway, null, null);
  }

  /** For a robot of the first floor that the server reaches itself. */
  public RobotOrder(
      String name,
      String host,
      int port,
      double maxLoad,
      @Nullable String parking,
      @Nullable PairingCode code) {
    this(name, host, port, maxLoad, parking, code, null);
  }
}
