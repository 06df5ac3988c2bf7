package org.toqa.link;

import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;

/** Links over TCP: encrypted to robots that were paired, plain to others. */
public final class TcpRobotLinkFactory implements RobotLinkFactory {
  /** Metres, far more than ours have. */
  private static final double USUAL_WIDEST_ROBOT = 1;

  private final LinkTls tls;
  private final RobotConnector connector;

  /**
   * @param tls of this server
   * @param plainOffLoopback whether robots on other machines that were not paired may be spoken to
   *     without encryption; where not, such a link only says so
   * @param widestRobot the largest diameter that a robot may say, metres, above 0
   */
  public TcpRobotLinkFactory(LinkTls tls, boolean plainOffLoopback, double widestRobot) {
    this.tls = tls;
    this.connector = new RobotConnector(tls, plainOffLoopback, widestRobot);
  }

  /** For robots that are 1 m wide at most. */
  public TcpRobotLinkFactory(LinkTls tls, boolean plainOffLoopback) {
    this(tls, plainOffLoopback, USUAL_WIDEST_ROBOT);
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    TcpRobotLink link = new TcpRobotLink(address, connector, listener);
    link.start();
    return link;
  }

  @Override
  public PairingResult pair(String robot, String host, int port, PairingCode code) {
    return new PairingClient(tls, robot, host + ":" + port, code).pair(host, port);
  }
}
