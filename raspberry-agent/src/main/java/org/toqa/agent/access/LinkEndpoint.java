package org.toqa.agent.access;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.link.channel.ConnectionListener;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.link.trust.PrivateFolder;

/**
 * Where a daemon accepts connections, encrypted or not for as long as it is open: not where the
 * robot was never paired, shows no code, and may do without. A robot that may not do without and
 * was never paired shows a code by itself. While it is open an encrypted endpoint takes new codes
 * by {@link PairingRequestFile}.
 *
 * <p>Any thread may call it; none waits.
 */
public final class LinkEndpoint implements AutoCloseable {

  private final LinkEndpointConfig config;
  private final RejectedConnections rejected;
  private final @Nullable LinkTls tls;
  private final @Nullable PeerPolicy policy;
  private final @Nullable PairingOffer pairingOffer;
  private final @Nullable PairingRequestWatcher requestWatcher;
  private final ConnectionAcceptor acceptor;
  private final ConnectionListener listener;

  /**
   * Opens it.
   *
   * @param onAccepted is given each connection of a peer with a role, by a thread of the endpoint's
   * @throws IOException with a sentence for people
   */
  public LinkEndpoint(LinkEndpointConfig config, Consumer<LinkSocket> onAccepted)
      throws IOException {
    this.config = config;
    rejected = new RejectedConnections(config.robot(), config.nanos());
    ServerPin pin = new ServerPin(config.folder());
    boolean paired = pin.server().isPresent();
    if (!paired && !config.showCode() && config.canBePlain()) {
      tls = null;
      policy = null;
      pairingOffer = null;
      requestWatcher = null;
      acceptor = new PlainConnectionAcceptor(onAccepted);
    } else {
      LinkTls own = new LinkTls(IdentityFile.open(config.folder()));
      PeerPolicy peers = new PeerPolicy(pin);
      Fingerprint robot = own.fingerprint();
      PairingOffer code = config.showCode() || !paired ? newOffer(robot) : null;
      PairingHandler pairing = new PairingHandler(config.robot(), peers, rejected, code);
      tls = own;
      policy = peers;
      pairingOffer = code;
      acceptor = new TlsConnectionAcceptor(own, peers, pairing, rejected, onAccepted);
      requestWatcher =
          new PairingRequestWatcher(
              config.robot(),
              new PairingRequestFile(config.folder()),
              asked -> pairing.setOffer(new PairingOffer(asked, robot, config.nanos())));
    }
    try {
      listener =
          new ConnectionListener(
              config.robot(),
              new InetSocketAddress(config.address(), config.port()),
              this::receive);
    } catch (IOException e) {
      closeRequestWatcher();
      throw new IOException(
          "Port %d on %s cannot be listened on (%s); is another daemon running there?"
              .formatted(config.port(), config.address().getHostAddress(), e.getMessage()),
          e);
    }
    listener.start();
  }

  /**
   * Makes this the only server of the daemon that will be opened on the folder, as pairing would:
   * for whoever runs both.
   *
   * @param folder the daemon's, which no daemon has now
   * @throws IOException with a sentence for people
   */
  public static void pinServer(Path folder, Fingerprint server) throws IOException {
    PrivateFolder.create(folder);
    ServerPin pin = new ServerPin(folder);
    if (!pin.server().equals(Optional.of(server))) {
      pin.save(server);
    }
  }

  private void receive(Socket client) throws IOException {
    try {
      client.setTcpNoDelay(true);
      client.setKeepAlive(true);
    } catch (IOException e) {
      client.close();
      throw e;
    }
    acceptor.accept(client);
  }

  private PairingOffer newOffer(Fingerprint robot) {
    return new PairingOffer(PairingCode.of(robot, new SecureRandom()), robot, config.nanos());
  }

  private void closeRequestWatcher() {
    if (requestWatcher != null) {
      requestWatcher.close();
    }
  }

  /** The port of TCP that it listens on, 1 to 65535. */
  public int port() {
    return listener.port();
  }

  /** Empty where the link is not encrypted. */
  public Optional<LinkTls> tls() {
    return Optional.ofNullable(tls);
  }

  /** The code that is shown from the beginning, as people read it. */
  public Optional<String> pairingCode() {
    return Optional.ofNullable(pairingOffer).map(PairingOffer::text);
  }

  /**
   * What a peer may send now.
   *
   * @param peer null where the link is not encrypted
   */
  public PeerRole roleOf(@Nullable Fingerprint peer) {
    if (policy == null) {
      return PeerRole.ANONYMOUS;
    }
    return peer == null ? PeerRole.UNTRUSTED : policy.roleOf(peer);
  }

  /** The server has named a leader: it may connect from now on. */
  public void setLeader(Fingerprint leader) {
    if (policy != null) {
      policy.setLeader(leader);
    }
  }

  /** Whose connection it rejected of late; empty where there was none. */
  public Optional<Fault> rejection() {
    return rejected.fault();
  }

  @Override
  public void close() {
    closeRequestWatcher();
    listener.close();
    acceptor.close();
  }

  @Override
  public String toString() {
    return "%s port %d".formatted(config.address(), port());
  }
}
