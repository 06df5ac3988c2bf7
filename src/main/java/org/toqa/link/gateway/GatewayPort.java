package org.toqa.link.gateway;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.ConnectionListener;
import org.toqa.link.message.GatewayMessage;
import org.toqa.link.message.GatewayMessage.Gateway;
import org.toqa.link.message.GatewayMessage.Stream;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.HandshakeException;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PendingConnections;
import org.toqa.link.trust.TimeLimit;

/**
 * The server's port for gateways. Each connection shows by its certificate which gateway makes it,
 * and by its first line what it is for; it has five seconds for both. Each link to a robot has a
 * connection of its own, so none waits for another, and TCP says when to wait.
 */
public final class GatewayPort implements Gateways, AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(GatewayPort.class);

  private static final Duration IDENTIFY_LIMIT = Duration.ofSeconds(5);

  /** More than gateways make at once. */
  private static final int MAX_PENDING = 64;

  private final LinkTls tls;
  private final InstantSource clock;
  private final ConnectionListener listener;
  private final Map<Fingerprint, Member> members = new LinkedHashMap<>();
  private final PendingConnections pending = new PendingConnections(MAX_PENDING);
  private final RejectedGateways rejected = new RejectedGateways(System::nanoTime);
  private final AtomicLong streams = new AtomicLong();

  /** A gateway that is known; guarded by itself. */
  private static final class Member {
    private final String name;
    private @Nullable GatewayConnection connection;
    private Instant since;

    Member(String name, Instant since) {
      this.name = name;
      this.since = since;
    }

    synchronized @Nullable GatewayConnection connection() {
      return connection;
    }

    synchronized GatewayState state() {
      String address = connection == null ? null : connection.address();
      return new GatewayState(name, connection != null, since, address);
    }

    /** The newer connection counts: the older one's end may just not be known yet. */
    synchronized void connected(GatewayConnection newer, Instant now) {
      GatewayConnection.closeQuietly(connection);
      connection = newer;
      since = now;
    }

    synchronized void ended(GatewayConnection ended, Instant now) {
      if (connection == ended) {
        connection = null;
        since = now;
      }
    }
  }

  /**
   * Listens from now on.
   *
   * @param trusted the gateways, by their names
   * @throws IOException if it cannot; the message says what to do
   */
  public GatewayPort(
      InetSocketAddress address, LinkTls tls, Map<String, Fingerprint> trusted, InstantSource clock)
      throws IOException {
    this.tls = tls;
    this.clock = clock;
    trusted.forEach((name, key) -> members.put(key, new Member(name, clock.instant())));
    try {
      listener = new ConnectionListener("gateways", address, this::receive);
    } catch (IOException e) {
      throw new IOException(
          "Gateways cannot be listened for on port %d of %s (%s): choose another one by gateways.port and gateways.address."
              .formatted(address.getPort(), address.getHostString(), e.getMessage()),
          e);
    }
    listener.start();
  }

  /** Of TCP. */
  public int port() {
    return listener.port();
  }

  @Override
  public LinkSocket open(String gateway, String host, int port) throws GatewayException {
    Member member =
        members.values().stream()
            .filter(m -> m.name.equals(gateway))
            .findFirst()
            .orElseThrow(
                () -> new GatewayException(GatewayException.Reason.UNKNOWN_GATEWAY, gateway));
    GatewayConnection connection = member.connection();
    if (connection == null) {
      throw new GatewayException(GatewayException.Reason.GATEWAY_NOT_CONNECTED, gateway);
    }
    return connection.open(host, port);
  }

  @Override
  public List<GatewayState> states() {
    return members.values().stream().map(Member::state).toList();
  }

  @Override
  public void close() {
    listener.close();
    pending.all().forEach(GatewayConnection::closeQuietly);
    members.values().forEach(m -> GatewayConnection.closeQuietly(m.connection()));
  }

  private void receive(Socket client) {
    pending.add(client).ifPresent(GatewayConnection::closeQuietly);
    Thread.startVirtualThread(() -> serve(client));
  }

  private void serve(Socket client) {
    LinkSocket link = null;
    GatewayMessage first;
    try (TimeLimit _ = new TimeLimit(client, IDENTIFY_LIMIT)) {
      client.setTcpNoDelay(true);
      link = tls.acceptGateway(client, this::isTrusted, IDENTIFY_LIMIT);
      first = FirstLine.read(link.in());
    } catch (IOException e) {
      GatewayConnection.closeQuietly(client);
      reject(client, link == null ? sentence(e) : "a gateway that says nothing of use");
      return;
    } finally {
      pending.remove(client);
    }
    Member member = members.get(link.peer());
    if (member != null) {
      serve(member, link, first);
    }
  }

  private void serve(Member member, LinkSocket link, GatewayMessage first) {
    switch (first) {
      case Gateway(int version) when version == GatewayMessage.VERSION -> talk(member, link);
      case Gateway(int version) -> {
        log.warn(
            "Gateway {} speaks version {} of its protocol, this server version {}; update the older one.",
            member.name,
            version,
            GatewayMessage.VERSION);
        GatewayConnection.closeQuietly(link);
      }
      case Stream(long stream) -> {
        GatewayConnection connection = member.connection();
        if (connection == null) {
          GatewayConnection.closeQuietly(link);
        } else {
          connection.take(stream, link);
        }
      }
      default -> GatewayConnection.closeQuietly(link);
    }
  }

  private void talk(Member member, LinkSocket link) {
    try (GatewayConnection connection = new GatewayConnection(member.name, link, streams)) {
      member.connected(connection, clock.instant());
      log.info("Gateway {}: connected from {}.", member.name, connection.address());
      try {
        connection.run();
      } finally {
        member.ended(connection, clock.instant());
      }
    } catch (IOException e) {
      log.warn("Gateway {}: its connection has ended: {}", member.name, e.getMessage());
    }
  }

  private boolean isTrusted(Fingerprint peer, String protocol) {
    return protocol.equals(LinkTls.GATEWAY) && members.containsKey(peer);
  }

  private void reject(Socket client, String why) {
    if (!listener.isClosed()) {
      rejected.record(client.getInetAddress().getHostAddress(), why);
    }
  }

  private static String sentence(IOException e) {
    return switch (LinkTls.reasonOf(e)) {
      case UNTRUSTED_PEER ->
          "it is none of the gateways in gateways.trusted"
              + (e instanceof HandshakeException ? " (" + e.getMessage() + ")" : "");
      case REJECTED_BY_PEER -> "it does not trust this server's certificate";
      case NOT_TLS -> "it does not encrypt";
      case CUT_OFF, TIMED_OUT -> "it did not show in time who it is";
      case FAILED -> "no connection by TLS 1.3 came about";
    };
  }
}
