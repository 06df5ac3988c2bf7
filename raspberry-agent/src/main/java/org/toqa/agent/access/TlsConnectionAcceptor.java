package org.toqa.agent.access;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.trust.HandshakeException;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PendingConnections;

/**
 * Accepts peers that have shown a certificate which {@link PeerPolicy} trusts. Each connection has
 * a thread and five seconds of its own, so one that is slow delays no other.
 */
final class TlsConnectionAcceptor implements ConnectionAcceptor {

  private static final Logger log = LoggerFactory.getLogger(TlsConnectionAcceptor.class);
  private static final Duration LIMIT = Duration.ofSeconds(5);

  private static final int MAX_PENDING = 16;

  private final LinkTls tls;
  private final PeerPolicy policy;
  private final PairingHandler pairing;
  private final RejectedConnections rejected;
  private final Consumer<LinkSocket> onAccepted;
  private final PendingConnections pending = new PendingConnections(MAX_PENDING);

  TlsConnectionAcceptor(
      LinkTls tls,
      PeerPolicy policy,
      PairingHandler pairing,
      RejectedConnections rejected,
      Consumer<LinkSocket> onAccepted) {
    this.tls = tls;
    this.policy = policy;
    this.pairing = pairing;
    this.rejected = rejected;
    this.onAccepted = onAccepted;
  }

  @Override
  public void accept(Socket client) {
    pending.add(client).ifPresent(TlsConnectionAcceptor::closeSocket);
    Thread.startVirtualThread(() -> identify(client));
  }

  @Override
  public void close() {
    pending.all().forEach(TlsConnectionAcceptor::closeSocket);
  }

  private void identify(Socket client) {
    try {
      LinkSocket link = tls.accept(client, policy, LIMIT);
      if (link.isForPairing()) {
        pairing.handle(link);
      } else {
        onAccepted.accept(link);
      }
    } catch (HandshakeException e) {
      log.debug("A handshake failed.", e);
      rejected.record(sentence(e.reason()), client.getInetAddress());
    } catch (IOException e) {
      log.debug("A handshake failed.", e);
    } finally {
      pending.remove(client);
    }
  }

  private static String sentence(HandshakeException.Reason reason) {
    return switch (reason) {
      case UNTRUSTED_PEER -> "%s was refused: it is neither this robot's server nor its leader.";
      case REJECTED_BY_PEER -> "%s does not trust this robot's certificate.";
      case NOT_TLS -> "%s was refused: it does not encrypt.";
      case CUT_OFF -> "A connection from %s ended before it had shown who it is.";
      case TIMED_OUT -> "%s was refused: it took too long to show who it is.";
      case FAILED -> "%s was refused: no connection by TLS 1.3 came about.";
    };
  }

  private static void closeSocket(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("Closing a connection failed.", e);
    }
  }
}
