package org.toqa.app.server;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.function.IntPredicate;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.trust.PairingCode;

/**
 * Links of sites beside the first one: the simulated robots of this process, which know no keys,
 * are the first site's, and nobody else finds them at their ports.
 */
final class OtherSiteLinks implements RobotLinkFactory {
  /** Where nobody listens. */
  private static final int CLOSED_PORT = 1;

  private final RobotLinkFactory links;
  private final IntPredicate isSimulated;

  /**
   * @param isSimulated whether the robot that listens on that port of loopback is a simulated one
   */
  OtherSiteLinks(RobotLinkFactory links, IntPredicate isSimulated) {
    this.links = links;
    this.isSimulated = isSimulated;
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    return links.open(visible(address), listener);
  }

  @Override
  public PairingResult pair(RobotAddress robot, PairingCode code) {
    return links.pair(visible(robot), code);
  }

  private RobotAddress visible(RobotAddress address) {
    return isSimulated.test(address.port()) && isLoopback(address.host())
        ? address.withPort(CLOSED_PORT)
        : address;
  }

  private static boolean isLoopback(String host) {
    try {
      return InetAddress.getByName(host).isLoopbackAddress();
    } catch (UnknownHostException e) {
      return false; // nobody is there either
    }
  }
}
