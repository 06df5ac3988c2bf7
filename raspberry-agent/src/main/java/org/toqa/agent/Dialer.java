package org.toqa.agent;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.Optional;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;

/**
 * Connects a leader to its followers: encrypted, and pinned to the certificate that the server has
 * named; without encryption only where it has named none, and only on loopback or where the
 * configuration allows it by name.
 */
final class Dialer {

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(1);
  private static final Duration HANDSHAKE_LIMIT = Duration.ofSeconds(5);

  /** A follower that says nothing for so long is connected to anew. */
  private static final Duration SILENCE_LIMIT = Duration.ofSeconds(2);

  private final Optional<LinkTls> tls;
  private final boolean plainOffLoopback;

  /**
   * @param tls of this robot; empty where it is not paired
   */
  Dialer(Optional<LinkTls> tls, boolean plainOffLoopback) {
    this.tls = tls;
    this.plainOffLoopback = plainOffLoopback;
  }

  /**
   * Waits for the follower.
   *
   * @param fresh is connected by it
   */
  LinkSocket connect(Socket fresh, Follower follower) throws IOException {
    InetSocketAddress address = new InetSocketAddress(follower.host(), follower.port());
    boolean encrypts = follower.fingerprint() != null;
    if (!encrypts
        && !plainOffLoopback
        && !(address.getAddress() != null && address.getAddress().isLoopbackAddress())) {
      throw new IOException(
          "it is on another machine, and the server has named no certificate of it");
    }
    fresh.setTcpNoDelay(true);
    fresh.setSoTimeout((int) SILENCE_LIMIT.toMillis());
    fresh.connect(address, (int) CONNECT_LIMIT.toMillis());
    return follower.fingerprint() == null
        ? LinkSocket.plain(fresh)
        : encrypted(fresh, new Fingerprint(follower.fingerprint()));
  }

  private LinkSocket encrypted(Socket fresh, Fingerprint follower) throws IOException {
    return tls.orElseThrow(() -> new IOException("this robot is not paired"))
        .connect(fresh, LinkTls.LINK, (peer, _) -> peer.equals(follower), HANDSHAKE_LIMIT);
  }
}
