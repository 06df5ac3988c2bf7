package org.toqa.link;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.time.Duration;
import org.toqa.link.gateway.GatewayException;
import org.toqa.link.gateway.Gateways;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.HandshakeException;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.wording.Phrase;

/** Connects to robots, and says in a sentence why it cannot. */
final class RobotConnector {

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(3);
  private static final Duration HANDSHAKE_LIMIT = Duration.ofSeconds(5);

  private final LinkTls tls;
  private final Gateways gateways;
  private final boolean plainOffLoopback;
  private final double widestRobot;

  RobotConnector(LinkTls tls, Gateways gateways, boolean plainOffLoopback, double widestRobot) {
    this.tls = tls;
    this.gateways = gateways;
    this.plainOffLoopback = plainOffLoopback;
    this.widestRobot = widestRobot;
  }

  LinkTls tls() {
    return tls;
  }

  /** Diameter that a robot has at most, metres. */
  double widestRobot() {
    return widestRobot;
  }

  /**
   * Waits for the robot.
   *
   * @param silence the longest wait for a byte
   */
  LinkSocket connect(RobotAddress to, Duration silence) throws LinkException {
    Fingerprint pinned = to.fingerprint();
    LinkSocket carrier = reach(to, pinned != null || plainOffLoopback);
    try {
      carrier.setReadLimit(silence);
      return pinned == null
          ? carrier
          : tls.connect(carrier, LinkTls.LINK, (peer, _) -> peer.equals(pinned), HANDSHAKE_LIMIT);
    } catch (HandshakeException e) {
      throw trustFailure(to, e.reason(), e);
    } catch (IOException e) {
      throw unreachable(to.robot(), to.place(), e);
    }
  }

  /**
   * A connection to whoever listens there, and nothing said yet.
   *
   * @param isGuarded what is said on it will be encrypted, or need not be; else only on loopback
   */
  private LinkSocket reach(RobotAddress to, boolean isGuarded) throws LinkException {
    String gateway = to.gateway();
    if (gateway != null) {
      if (!isGuarded) {
        throw notPaired(to);
      }
      return reachThrough(gateway, to);
    }
    InetSocketAddress address = new InetSocketAddress(to.host(), to.port());
    InetAddress ip = address.getAddress();
    if (!isGuarded && ip != null && !ip.isLoopbackAddress()) {
      throw notPaired(to);
    }
    return LinkSocket.plain(connectTcp(to.robot(), to.place(), address));
  }

  /** A connection to whoever listens there, to pair with him by TLS. */
  LinkSocket reachToPair(RobotAddress to) throws LinkException {
    return reach(to, true);
  }

  private static LinkException notPaired(RobotAddress to) {
    return LinkException.trustFailure(Phrase.NOT_PAIRED.with(to.robot(), to.place()));
  }

  private LinkSocket reachThrough(String gateway, RobotAddress to) throws LinkException {
    try {
      return gateways.open(gateway, to.host(), to.port());
    } catch (GatewayException e) {
      String robot = to.robot();
      throw switch (e.reason()) {
        case UNKNOWN_GATEWAY ->
            LinkException.trustFailure(Phrase.GATEWAY_NOT_KNOWN.with(robot, gateway));
        case GATEWAY_NOT_CONNECTED ->
            LinkException.trustFailure(Phrase.GATEWAY_NOT_CONNECTED.with(robot, gateway));
        case NOT_ALLOWED ->
            LinkException.trustFailure(
                Phrase.GATEWAY_MAY_NOT_CONNECT.with(robot, gateway, to.host() + ":" + to.port()));
        case TOO_MANY_LINKS ->
            LinkException.trustFailure(Phrase.GATEWAY_IS_FULL.with(robot, gateway));
        case HOST_NOT_KNOWN -> new LinkException(Phrase.HOST_NOT_KNOWN.with(robot, to.place()));
        case DOES_NOT_ANSWER -> new LinkException(Phrase.DOES_NOT_ANSWER.with(robot, to.place()));
        case CANNOT_BE_REACHED ->
            new LinkException(
                Phrase.CANNOT_BE_REACHED.with(robot, to.place(), String.valueOf(e.getMessage())));
      };
    }
  }

  private static Socket connectTcp(String robot, String place, InetSocketAddress address)
      throws LinkException {
    Socket socket = new Socket();
    try {
      socket.setTcpNoDelay(true);
      socket.connect(address, (int) CONNECT_LIMIT.toMillis());
      return socket;
    } catch (IOException e) {
      try {
        socket.close();
      } catch (IOException suppressed) {
        e.addSuppressed(suppressed);
      }
      throw unreachable(robot, place, e);
    }
  }

  /**
   * Why an encrypted connection to a known robot did not come about.
   *
   * @param e whose message helps only where nothing is known
   */
  static LinkException trustFailure(RobotAddress to, Reason reason, IOException e) {
    String robot = to.robot();
    return switch (reason) {
      case UNTRUSTED_PEER ->
          LinkException.trustFailure(Phrase.HAS_ANOTHER_KEY.with(to.place(), robot));
      case REJECTED_BY_PEER ->
          LinkException.trustFailure(Phrase.DOES_NOT_ACCEPT_SERVER.with(robot));
      case NOT_TLS -> LinkException.trustFailure(Phrase.DOES_NOT_ENCRYPT.with(to.place(), robot));
      case FAILED ->
          LinkException.trustFailure(Phrase.NO_TLS.with(robot, String.valueOf(e.getMessage())));
      case CUT_OFF -> new LinkException(Phrase.CLOSED_THE_CONNECTION.with(robot));
      case TIMED_OUT -> new LinkException(Phrase.DOES_NOT_ANSWER.with(robot, to.place()));
    };
  }

  private static LinkException unreachable(String robot, String place, IOException e) {
    return switch (e) {
      case UnknownHostException _ -> new LinkException(Phrase.HOST_NOT_KNOWN.with(robot, place));
      case SocketTimeoutException _ -> new LinkException(Phrase.DOES_NOT_ANSWER.with(robot, place));
      case ConnectException _ when isRefused(e) ->
          new LinkException(Phrase.NOBODY_LISTENS.with(robot, place));
      default ->
          new LinkException(
              Phrase.CANNOT_BE_REACHED.with(robot, place, String.valueOf(e.getMessage())));
    };
  }

  /** The host is there and says no; of a host that is not there Java throws the same. */
  private static boolean isRefused(IOException e) {
    return String.valueOf(e.getMessage()).contains("refused");
  }
}
