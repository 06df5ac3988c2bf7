package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.link.RobotAddress;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;

/**
 * A robot as it is stored.
 *
 * @param maxLoad kilograms
 * @param parking a parking point's name; null: it stays where its last task ends
 * @param simulated whether its daemon runs in the server's process
 * @param fingerprint of its certificate, as pairing recorded it, or a person who entered it; null:
 *     its link is not encrypted
 * @param gateway the gateway that reaches it; null: the server does
 * @param token that it wants of the server, over HTTP; null: it speaks the robot link
 */
public record RobotRecord(
    String name,
    String floor,
    String host,
    int port,
    double maxLoad,
    @Nullable String parking,
    boolean simulated,
    @Nullable Fingerprint fingerprint,
    @Nullable String gateway,
    @Nullable RobotToken token) {

  /** Of a robot that speaks the robot link, and that the server reaches itself. */
  public static RobotRecord direct(
      String name,
      String floor,
      String host,
      int port,
      double maxLoad,
      @Nullable String parking,
      boolean simulated,
      @Nullable Fingerprint fingerprint) {
    return new RobotRecord(
        name, floor, host, port, maxLoad, parking, simulated, fingerprint, null, null);
  }

  /** Whether it takes wheel commands over HTTP; else it speaks the robot link. */
  public boolean isHttp() {
    return token != null;
  }

  public RobotAddress address() {
    return new RobotAddress(name, host, port, fingerprint, gateway, token);
  }

  /** The same robot on another floor, where it has no parking point. */
  public RobotRecord movedTo(String other) {
    return new RobotRecord(
        name, other, host, port, maxLoad, null, simulated, fingerprint, gateway, token);
  }

  /** The same robot at another address. */
  public RobotRecord withAddress(String newHost, int newPort) {
    return new RobotRecord(
        name, floor, newHost, newPort, maxLoad, parking, simulated, fingerprint, gateway, token);
  }

  public RobotRecord withChange(RobotChange change) {
    return new RobotRecord(
        name,
        floor,
        change.host(),
        change.port(),
        change.maxLoad(),
        change.parking(),
        simulated,
        change.fingerprint() == null ? fingerprint : change.fingerprint(),
        change.gateway(),
        change.token() == null ? token : change.token());
  }

  /** What a change can change of it, as it is. */
  public RobotChange toChange() {
    return new RobotChange(host, port, maxLoad, parking, gateway);
  }

  public RobotRecord withFingerprint(Fingerprint paired) {
    return new RobotRecord(
        name, floor, host, port, maxLoad, parking, simulated, paired, gateway, token);
  }
}
