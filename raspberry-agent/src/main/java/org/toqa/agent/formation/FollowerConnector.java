package org.toqa.agent.formation;

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
public final class FollowerConnector {

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(1);
  private static final Duration HANDSHAKE_LIMIT = Duration.ofSeconds(5);

  /** A follower that says nothing for so long is connected to anew. */
  private static final Duration SILENCE_LIMIT = Duration.ofSeconds(2);

  private final Optional<LinkTls> tls;
  private final boolean plainOffLoopback;

  /**
   * @param tls of this robot; empty where it is not paired
   */
  public FollowerConnector(Optional<LinkTls> tls, boolean plainOffLoopback) {
    this.tls = tls;
    this.plainOffLoopback = plainOffLoopback;
  }

  /**
   * Waits for the follower.
   *
   * @param socket is connected by it
   */
  LinkSocket connect(Socket socket, Follower follower) throws IOException {
    InetSocketAddress address = new InetSocketAddress(follower.host(), follower.port());
    boolean isEncrypted = follower.fingerprint() != null;
    if (!isEncrypted
        && !plainOffLoopback
        && !(address.getAddress() != null && address.getAddress().isLoopbackAddress())) {
      throw new IOException(
          "it is on another machine, and the server has named no certificate of it");
    }
    socket.setTcpNoDelay(true);
    socket.setSoTimeout((int) SILENCE_LIMIT.toMillis());
    socket.connect(address, (int) CONNECT_LIMIT.toMillis());
    return follower.fingerprint() == null
        ? LinkSocket.plain(socket)
        : connectEncrypted(socket, new Fingerprint(follower.fingerprint()));
  }

  private LinkSocket connectEncrypted(Socket socket, Fingerprint follower) throws IOException {
    return tls.orElseThrow(() -> new IOException("this robot is not paired"))
        .connect(socket, LinkTls.LINK, (peer, _) -> peer.equals(follower), HANDSHAKE_LIMIT);
  }
}
