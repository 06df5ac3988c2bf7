package org.toqa.app.server;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.InstantSource;
import java.util.Deque;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.accounts.Site;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.GatewaySettings;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.gateway.GatewayPort;
import org.toqa.link.gateway.Gateways;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.sim.VirtualClock;

/** How this server reaches its robots. */
final class ServerLinks {
  private static final Logger log = LoggerFactory.getLogger(ServerLinks.class);

  private ServerLinks() {}

  /**
   * @param site whose robots these are
   * @param ranges that its robots publish
   * @param parts gets what is to be closed
   * @throws IOException the server's key cannot be read, or gateways cannot be listened for
   */
  static RobotLinkFactory open(
      Site site,
      Configuration configuration,
      ServerParts shared,
      VirtualClock clock,
      PublishedRanges ranges,
      Deque<AutoCloseable> parts)
      throws IOException {
    LinkTls tls = new LinkTls(IdentityFile.open(configuration.data()));
    RobotLinkFactory links =
        new TcpRobotLinkFactory(
            tls,
            gateways(configuration.gateways(), tls, parts),
            configuration.plainLinks(),
            configuration.widestRobot());
    return new HttpRobotLinks(
        overTcp(links, site, configuration, shared, clock),
        links,
        configuration.data().resolve("http-robots"),
        tls.fingerprint(),
        configuration.plainLinks(),
        ranges,
        shared.clock());
  }

  private static RobotLinkFactory overTcp(
      RobotLinkFactory links,
      Site site,
      Configuration configuration,
      ServerParts shared,
      VirtualClock clock) {
    if (!site.isFirst()) {
      return new OtherSiteLinks(links, shared::isSimulated);
    }
    if (!configuration.isSimulated()) {
      return links;
    }
    SimulatedLinks waitedFor = new SimulatedLinks(links, shared::isSimulated, clock::nanos);
    clock.add(waitedFor, VirtualClock.STEP);
    return waitedFor;
  }

  private static Gateways gateways(
      @Nullable GatewaySettings settings, LinkTls tls, Deque<AutoCloseable> parts)
      throws IOException {
    if (settings == null) {
      return Gateways.NONE;
    }
    GatewayPort port =
        new GatewayPort(
            new InetSocketAddress(settings.address(), settings.port()),
            tls,
            settings.trusted(),
            InstantSource.system());
    parts.push(port);
    log.info(
        "Gateways connect to port {}; they know this server by the fingerprint {}.",
        port.port(),
        tls.fingerprint());
    return port;
  }
}
