package org.toqa.link.gateway;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.time.Duration;
import java.util.concurrent.Semaphore;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.Backoff;
import org.toqa.link.channel.LineChannel;
import org.toqa.link.channel.LineChannel.WhenFull;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.GatewayMessage;
import org.toqa.link.message.GatewayMessage.Gateway;
import org.toqa.link.message.GatewayMessage.Open;
import org.toqa.link.message.GatewayMessage.Ping;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;

/**
 * A gateway: it dials out to its server, again and again, and makes the connections to robots that
 * the server asks for. What goes through them it does not open. When the connection by which the
 * server asks has ended, so have all others.
 */
public final class GatewayAgent implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(GatewayAgent.class);

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(5);
  private static final Duration HANDSHAKE_LIMIT = Duration.ofSeconds(5);

  /** So many connections to the server are being made at once; others wait. */
  private static final int DIALLING_AT_ONCE = 8;

  private static final int QUEUED_LINES = 2_000;

  private final Server server;
  private final AllowedAddresses allowed;
  private final LinkTls tls;
  private final Semaphore dialling = new Semaphore(DIALLING_AT_ONCE);
  private final Thread thread;
  private volatile boolean isClosed;
  private String lastFailure = "";

  /**
   * @param port of TCP
   * @param fingerprint of the certificate that it must show
   */
  public record Server(String host, int port, Fingerprint fingerprint) {
    @Override
    public String toString() {
      return host + ":" + port;
    }
  }

  /**
   * Dials from now on.
   *
   * @param tls of this gateway
   */
  public GatewayAgent(Server server, AllowedAddresses allowed, LinkTls tls) {
    this.server = server;
    this.allowed = allowed;
    this.tls = tls;
    thread = Thread.ofVirtual().name("gateway").start(this::run);
  }

  @Override
  public void close() {
    isClosed = true;
    thread.interrupt(); // ends a wait, and the socket that is being connected or read
  }

  private void run() {
    Backoff backoff = new Backoff();
    while (!isClosed) {
      long began = System.nanoTime();
      try {
        runConnection();
      } catch (IOException e) {
        logFailure(e);
      } catch (RuntimeException e) { // else it would never dial again
        log.error("The connection to the server at {} failed.", server, e);
      }
      if (System.nanoTime() - began > Backoff.LONGEST.toNanos() * 2) {
        backoff.reset();
      }
      try {
        Thread.sleep(backoff.nextDelay());
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // only close() interrupts
      }
    }
  }

  private void runConnection() throws IOException {
    LinkSocket link = dial();
    link.setReadLimit(GatewayConnection.SILENCE_LIMIT);
    try (LineChannel channel = new LineChannel(link, "gateway", QUEUED_LINES, WhenFull.CLOSE);
        CarriedLinks links = new CarriedLinks(allowed, this::dialOneOfFew, channel)) {
      channel.start();
      channel.send(LinkCodec.encode(new Gateway(GatewayMessage.VERSION)));
      boolean isWelcome = false;
      while (!isClosed) {
        LineReader.Line line = channel.readLine();
        if (line == null) {
          throw new IOException("it closed the connection");
        }
        if (!isWelcome) {
          isWelcome = true;
          lastFailure = "";
          log.info("Connected to the server at {}.", server);
        }
        receive(line, channel, links);
      }
    }
  }

  private static void receive(LineReader.Line line, LineChannel channel, CarriedLinks links)
      throws IOException {
    switch (LinkCodec.decodeGatewayMessage(line)) {
      case Decoded<GatewayMessage>(Ping ping) -> channel.send(LinkCodec.encode(ping));
      case Decoded<GatewayMessage>(Open open) -> links.open(open);
      default -> throw new IOException("it says what no server says to a gateway");
    }
  }

  /** A connection to the server, and nothing said yet. */
  private LinkSocket dial() throws IOException {
    Socket socket = new Socket();
    try {
      socket.setTcpNoDelay(true);
      socket.setKeepAlive(true);
      socket.connect(
          new InetSocketAddress(server.host(), server.port()), (int) CONNECT_LIMIT.toMillis());
    } catch (IOException e) {
      GatewayConnection.closeQuietly(socket);
      throw e;
    }
    return tls.connect(
        socket, LinkTls.GATEWAY, (peer, _) -> peer.equals(server.fingerprint()), HANDSHAKE_LIMIT);
  }

  private LinkSocket dialOneOfFew() throws IOException, InterruptedException {
    dialling.acquire();
    try {
      return dial();
    } finally {
      dialling.release();
    }
  }

  /** Once for each reason, not once for each attempt. */
  private void logFailure(IOException e) {
    String why =
        switch (LinkTls.reasonOf(e)) {
          case UNTRUSTED_PEER ->
              "its fingerprint is not the one in the configuration (server.fingerprint)";
          case REJECTED_BY_PEER ->
              "it does not let this gateway in; its configuration must name %s in gateways.trusted"
                  .formatted(tls.fingerprint());
          case NOT_TLS -> "it does not encrypt: is this the port for gateways?";
          case TIMED_OUT -> "it says nothing";
          case CUT_OFF, FAILED -> String.valueOf(e.getMessage());
        };
    if (!isClosed && !why.equals(lastFailure)) {
      lastFailure = why;
      log.warn("There is no connection to the server at {}: {}", server, why);
    }
  }
}
