package org.toqa.link;

import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;

/** Links over TCP: encrypted to robots that were paired, plain to others. */
public final class TcpRobotLinks implements RobotLinks {

  private final LinkTls tls;
  private final Dialer dialer;

  /**
   * @param tls of this server
   * @param plainOffLoopback whether robots on other machines that were not paired may be spoken to
   *     without encryption; where not, such a link only says so
   */
  public TcpRobotLinks(LinkTls tls, boolean plainOffLoopback) {
    this.tls = tls;
    this.dialer = new Dialer(tls, plainOffLoopback);
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    TcpRobotLink link = new TcpRobotLink(address, dialer, listener);
    link.start();
    return link;
  }

  @Override
  public PairingResult pair(String robot, String host, int port, PairingCode code) {
    return new PairingCall(tls, robot, host + ":" + port, code).to(host, port);
  }
}
