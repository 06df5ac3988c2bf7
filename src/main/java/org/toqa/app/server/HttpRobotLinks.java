package org.toqa.app.server;

import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.gateway.GatewayState;
import org.toqa.link.http.HttpRobotAddress;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.wording.Phrase;

/** Links of which some are to robots that take wheel commands over HTTP. */
final class HttpRobotLinks implements RobotLinkFactory {
  private final RobotLinkFactory links;
  private final RobotLinkFactory daemonLinks;
  private final Path folder;
  private final Fingerprint server;
  private final boolean plainOffLoopback;
  private final PublishedRanges ranges;
  private final InstantSource clock;

  /**
   * @param links to all other robots
   * @param daemonLinks to the daemons that this server runs, each on loopback
   * @param folder one folder for each of these is kept in it, with the robot's name
   * @param server the certificate by which they know the server
   * @param plainOffLoopback whether robots on other machines may be spoken to without encryption
   * @param ranges that robots of the site publish
   * @param clock for stamps
   */
  HttpRobotLinks(
      RobotLinkFactory links,
      RobotLinkFactory daemonLinks,
      Path folder,
      Fingerprint server,
      boolean plainOffLoopback,
      PublishedRanges ranges,
      InstantSource clock) {
    this.links = links;
    this.daemonLinks = daemonLinks;
    this.folder = folder;
    this.server = server;
    this.plainOffLoopback = plainOffLoopback;
    this.ranges = ranges;
    this.clock = clock;
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    RobotToken token = address.token();
    if (token == null) {
      return links.open(address, listener);
    }
    HttpRobotLink link =
        new HttpRobotLink(
            address,
            new HttpRobotAddress(address.host(), address.port(), token, address.fingerprint()),
            new HttpRobotLink.Surroundings(
                daemonLinks,
                folder.resolve(address.robot()),
                server,
                plainOffLoopback,
                ranges.of(address.robot()),
                clock),
            listener);
    link.start();
    return link;
  }

  @Override
  public PairingResult pair(RobotAddress robot, PairingCode code) {
    return robot.token() == null
        ? links.pair(robot, code)
        : new PairingResult.Refused(Phrase.HTTP_IS_NOT_PAIRED.with(robot.robot()));
  }

  @Override
  public List<GatewayState> gateways() {
    return links.gateways();
  }
}
