package org.toqa.link;

import java.util.List;
import org.toqa.link.gateway.GatewayState;
import org.toqa.link.gateway.Gateways;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;

/**
 * Links over TCP, some of them through gateways: encrypted to robots that were paired, plain to
 * others.
 */
public final class TcpRobotLinkFactory implements RobotLinkFactory {
  /** Metres, far more than ours have. */
  private static final double USUAL_WIDEST_ROBOT = 1;

  private final Gateways gateways;
  private final RobotConnector connector;

  /**
   * @param tls of this server
   * @param gateways of this server
   * @param plainOffLoopback whether robots on other machines that were not paired may be spoken to
   *     without encryption; where not, such a link only says so
   * @param widestRobot the largest diameter that a robot may say, metres, above 0
   */
  public TcpRobotLinkFactory(
      LinkTls tls, Gateways gateways, boolean plainOffLoopback, double widestRobot) {
    this.gateways = gateways;
    this.connector = new RobotConnector(tls, gateways, plainOffLoopback, widestRobot);
  }

  /** Without gateways, for robots that are 1 m wide at most. */
  public TcpRobotLinkFactory(LinkTls tls, boolean plainOffLoopback) {
    this(tls, Gateways.NONE, plainOffLoopback, USUAL_WIDEST_ROBOT);
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    TcpRobotLink link = new TcpRobotLink(address, connector, listener);
    link.start();
    return link;
  }

  @Override
  public PairingResult pair(RobotAddress robot, PairingCode code) {
    return new PairingClient(connector, robot, code).pair();
  }

  @Override
  public List<GatewayState> gateways() {
    return gateways.states();
  }
}
