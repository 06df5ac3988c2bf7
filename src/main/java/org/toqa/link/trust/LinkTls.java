package org.toqa.link.trust;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.security.GeneralSecurityException;
import java.security.cert.X509Certificate;
import java.time.Duration;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManager;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.trust.HandshakeException.Reason;

/**
 * TLS 1.3 over connections of the robot link, at either end: both ends show their certificates, and
 * each lets in whom it was told to. Each connection has a context of its own, so that no earlier
 * session can be taken up after the trust in it has ended.
 */
public final class LinkTls {

  /** The protocol (ALPN) of a server or a leader. */
  public static final String LINK = "toqa/1";

  /** The protocol (ALPN) of a server that pairs. */
  public static final String PAIRING = "toqa-pair/1";

  /** The protocol (ALPN) of a gateway. */
  public static final String GATEWAY = "toqa-gateway/1";

  /** Every TLS connection begins with a record of this type. */
  private static final int HANDSHAKE_RECORD = 22;

  private static final Duration LONGEST_FAREWELL = Duration.ofSeconds(1);
  private static final int MAX_UNREAD_BYTES = 16_384;

  private static final Logger log = LoggerFactory.getLogger(LinkTls.class);

  private final Identity identity;

  public LinkTls(Identity identity) {
    this.identity = identity;
  }

  /** What this end is known by. */
  public Fingerprint fingerprint() {
    return identity.fingerprint();
  }

  /**
   * Goes on, as the client, with a connection that was made. Nothing but the greeting of TLS is
   * sent before the other end is found to be trusted. Whether the other end trusts this one shows
   * with the first line that is read.
   *
   * @param limit of real time for the whole handshake
   * @return the encrypted connection
   * @throws HandshakeException the socket is closed then
   */
  public LinkSocket connect(
      Socket connected, String protocol, PeerVerifier verifier, Duration limit) throws IOException {
    return connect(LinkSocket.plain(connected), protocol, verifier, limit);
  }

  /** As the other one, within a connection that may be encrypted itself. */
  public LinkSocket connect(
      LinkSocket carrier, String protocol, PeerVerifier verifier, Duration limit)
      throws IOException {
    Socket connected = carrier.stream();
    try (TimeLimit time = carrier.startTimeLimit(limit)) {
      try {
        SSLSocket tls =
            (SSLSocket)
                context(verifier)
                    .getSocketFactory()
                    .createSocket(
                        connected,
                        connected.getInetAddress().getHostAddress(),
                        connected.getPort(),
                        false);
        return handshake(carrier.tcp(), tls, protocol);
      } catch (IOException e) {
        HandshakeException failure = failure(time, e);
        closeFailed(carrier);
        throw failure;
      }
    }
  }

  /**
   * Goes on, as a robot, with a connection that was taken.
   *
   * @param limit of real time for the whole handshake
   * @throws HandshakeException the socket is closed then
   */
  public LinkSocket accept(Socket accepted, PeerVerifier verifier, Duration limit)
      throws IOException {
    return accept(accepted, verifier, limit, PAIRING, LINK);
  }

  /** The same of a gateway. */
  public LinkSocket acceptGateway(Socket accepted, PeerVerifier verifier, Duration limit)
      throws IOException {
    return accept(accepted, verifier, limit, GATEWAY);
  }

  private LinkSocket accept(
      Socket accepted, PeerVerifier verifier, Duration limit, String... protocols)
      throws IOException {
    try (TimeLimit time = new TimeLimit(accepted, limit)) {
      try {
        int first = accepted.getInputStream().read();
        if (first >= 0 && first != HANDSHAKE_RECORD) {
          throw new HandshakeException(
              Reason.NOT_TLS,
              "It begins with the byte " + first + ".",
              new SSLException("plain text"));
        }
        byte[] read = first < 0 ? new byte[0] : new byte[] {(byte) first};
        SSLSocket tls =
            (SSLSocket)
                context(verifier)
                    .getSocketFactory()
                    .createSocket(accepted, new ByteArrayInputStream(read), false);
        tls.setUseClientMode(false);
        tls.setNeedClientAuth(true);
        return handshake(accepted, tls, protocols);
      } catch (IOException e) {
        HandshakeException failure = failure(time, e);
        closeFailed(LinkSocket.plain(accepted));
        throw failure;
      }
    }
  }

  /** What a failure to read the first line of a connection that was made comes from. */
  public static Reason reasonOf(IOException failure) {
    for (Throwable e = failure; e != null; e = e.getCause()) {
      switch (e) {
        case HandshakeException known -> {
          return known.reason();
        }
        case PinnedTrustManager.UntrustedPeerException _ -> {
          return Reason.UNTRUSTED_PEER;
        }
        case EOFException _, SocketException _ -> {
          return Reason.CUT_OFF;
        }
        case SocketTimeoutException _ -> {
          return Reason.TIMED_OUT;
        }
        case SSLException tls when hasMessage(tls, "Received fatal alert") -> {
          return Reason.REJECTED_BY_PEER;
        }
        case SSLException tls when hasMessage(tls, "Unsupported or unrecognized SSL message") -> {
          return Reason.NOT_TLS;
        }
        default -> {}
      }
    }
    return Reason.FAILED;
  }

  private static boolean hasMessage(SSLException e, String words) {
    return e.getMessage() != null && e.getMessage().contains(words);
  }

  private static LinkSocket handshake(Socket tcp, SSLSocket tls, String... protocols)
      throws IOException {
    SSLParameters parameters = tls.getSSLParameters();
    parameters.setProtocols(new String[] {"TLSv1.3"});
    parameters.setApplicationProtocols(protocols);
    tls.setSSLParameters(parameters);
    tls.startHandshake();
    try {
      X509Certificate shown = (X509Certificate) tls.getSession().getPeerCertificates()[0];
      return new LinkSocket(tcp, tls, Fingerprint.of(shown), tls.getApplicationProtocol());
    } catch (GeneralSecurityException e) {
      throw new IOException(e);
    }
  }

  private SSLContext context(PeerVerifier verifier) throws IOException {
    try {
      SSLContext context = SSLContext.getInstance("TLSv1.3");
      context.init(
          identity.keyManagers(), new TrustManager[] {new PinnedTrustManager(verifier)}, null);
      return context;
    } catch (GeneralSecurityException e) {
      throw new IOException("TLS cannot be had: " + e.getMessage(), e);
    }
  }

  private static HandshakeException failure(TimeLimit time, IOException e) {
    Reason reason = reasonOf(e);
    if (time.hasPassed() && (reason == Reason.CUT_OFF || reason == Reason.FAILED)) {
      reason = Reason.TIMED_OUT;
    }
    return e instanceof HandshakeException known && known.reason() == reason
        ? known
        : new HandshakeException(reason, String.valueOf(e.getMessage()), e);
  }

  /**
   * Closes a socket over which an alert may have been sent, after the other end has read it: one
   * that still writes while the socket is closed would lose the alert, and see only a broken
   * connection.
   */
  private static void closeFailed(LinkSocket failed) {
    try (failed;
        TimeLimit _ = failed.startTimeLimit(LONGEST_FAREWELL)) {
      failed.endOutput();
      failed.in().readNBytes(MAX_UNREAD_BYTES);
    } catch (IOException e) {
      log.debug("A connection that failed ended.", e);
    }
  }
}
