package org.toqa.link;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.time.Duration;
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
  private final boolean plainOffLoopback;
  private final double widestRobot;

  RobotConnector(LinkTls tls, boolean plainOffLoopback, double widestRobot) {
    this.tls = tls;
    this.plainOffLoopback = plainOffLoopback;
    this.widestRobot = widestRobot;
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
    Socket socket = openSocket(to);
    try {
      socket.setSoTimeout((int) silence.toMillis());
      Fingerprint pinned = to.fingerprint();
      return pinned == null
          ? LinkSocket.plain(socket)
          : tls.connect(socket, LinkTls.LINK, (peer, _) -> peer.equals(pinned), HANDSHAKE_LIMIT);
    } catch (HandshakeException e) {
      throw trustFailure(to, e.reason(), e);
    } catch (IOException e) {
      throw unreachable(to.robot(), to.hostAndPort(), e);
    }
  }

  private Socket openSocket(RobotAddress to) throws LinkException {
    InetSocketAddress address = new InetSocketAddress(to.host(), to.port());
    InetAddress ip = address.getAddress();
    if (ip != null && !ip.isLoopbackAddress() && to.fingerprint() == null && !plainOffLoopback) {
      throw LinkException.trustFailure(Phrase.NOT_PAIRED.with(to.robot(), to.hostAndPort()));
    }
    return connectTcp(to.robot(), to.hostAndPort(), address);
  }

  /** A TCP connection, and nothing said yet. */
  static Socket connectTcp(String robot, String place, InetSocketAddress address)
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
          LinkException.trustFailure(Phrase.HAS_ANOTHER_KEY.with(to.hostAndPort(), robot));
      case REJECTED_BY_PEER ->
          LinkException.trustFailure(Phrase.DOES_NOT_ACCEPT_SERVER.with(robot));
      case NOT_TLS ->
          LinkException.trustFailure(Phrase.DOES_NOT_ENCRYPT.with(to.hostAndPort(), robot));
      case FAILED ->
          LinkException.trustFailure(Phrase.NO_TLS.with(robot, String.valueOf(e.getMessage())));
      case CUT_OFF -> new LinkException(Phrase.CLOSED_THE_CONNECTION.with(robot));
      case TIMED_OUT -> new LinkException(Phrase.DOES_NOT_ANSWER.with(robot, to.hostAndPort()));
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
