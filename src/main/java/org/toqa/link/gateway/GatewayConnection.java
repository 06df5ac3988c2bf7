package org.toqa.link.gateway;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.LineChannel;
import org.toqa.link.channel.LineChannel.WhenFull;
import org.toqa.link.gateway.GatewayException.Reason;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.GatewayMessage;
import org.toqa.link.message.GatewayMessage.NotOpened;
import org.toqa.link.message.GatewayMessage.Open;
import org.toqa.link.message.GatewayMessage.Ping;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.trust.LinkSocket;

/** What a server and one gateway say to each other, at the server's end. */
final class GatewayConnection implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(GatewayConnection.class);

  /** Each end says something each second. */
  static final Duration SILENCE_LIMIT = Duration.ofSeconds(5);

  private static final Duration PING_INTERVAL = Duration.ofSeconds(1);

  /** More than the gateway waits for the robot and for a further connection to the server. */
  private static final Duration OPEN_LIMIT = Duration.ofSeconds(7);

  private static final int QUEUED_LINES = 2_000;

  /** Far more than the answers to all robots' attempts. */
  private static final int MAX_LINES_A_SECOND = 5_000;

  private final String address;
  private final LineChannel channel;
  private final AtomicLong numbers;
  private final Map<Long, CompletableFuture<LinkSocket>> awaited = new ConcurrentHashMap<>();
  private final Thread pinger;
  private volatile boolean isClosed;

  /**
   * @param numbers of the streams, over all connections: an older one's are never taken for these
   */
  GatewayConnection(String gateway, LinkSocket socket, AtomicLong numbers) throws IOException {
    this.address = socket.remoteAddress().getHostAddress();
    this.numbers = numbers;
    socket.setReadLimit(SILENCE_LIMIT);
    channel = new LineChannel(socket, "gateway-" + gateway, QUEUED_LINES, WhenFull.CLOSE);
    pinger = Thread.ofVirtual().name("gateway-" + gateway + "-pings").unstarted(this::ping);
  }

  String address() {
    return address;
  }

  /**
   * Reads until it ends.
   *
   * @throws IOException why it has ended
   */
  void run() throws IOException {
    try (this) {
      channel.start();
      pinger.start();
      long second = System.nanoTime();
      int lines = 0;
      while (true) {
        LineReader.Line line = channel.readLine();
        if (line == null) {
          throw new IOException("the gateway closed it");
        }
        if (System.nanoTime() - second > TimeUnit.SECONDS.toNanos(1)) {
          second = System.nanoTime();
          lines = 0;
        }
        if (++lines > MAX_LINES_A_SECOND) {
          throw new IOException("the gateway says too much");
        }
        receive(line);
      }
    }
  }

  private void receive(LineReader.Line line) throws IOException {
    switch (LinkCodec.decodeGatewayMessage(line)) {
      case Decoded<GatewayMessage>(Ping _) -> {}
      case Decoded<GatewayMessage>(NotOpened answer) -> {
        CompletableFuture<LinkSocket> asked = awaited.remove(answer.stream());
        if (asked != null) {
          asked.completeExceptionally(GatewayException.of(answer));
        }
      }
      default -> throw new IOException("the gateway says what no gateway says");
    }
  }

  /** As {@link Gateways#open}. */
  LinkSocket open(String host, int port) throws GatewayException {
    long stream = numbers.incrementAndGet();
    CompletableFuture<LinkSocket> asked = new CompletableFuture<>();
    awaited.put(stream, asked);
    try {
      if (isClosed || !channel.send(LinkCodec.encode(new Open(stream, host, port)))) {
        throw notConnected();
      }
      return asked.get(OPEN_LIMIT.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException e) {
      throw e.getCause() instanceof GatewayException why
          ? why
          : new GatewayException(Reason.CANNOT_BE_REACHED, String.valueOf(e.getCause()));
    } catch (TimeoutException e) {
      abandon(asked);
      throw new GatewayException(Reason.DOES_NOT_ANSWER, "");
    } catch (InterruptedException e) {
      abandon(asked);
      Thread.currentThread().interrupt();
      throw notConnected();
    } finally {
      awaited.remove(stream);
    }
  }

  /**
   * A connection to a robot has come; nobody who asked for it is there any more where it is closed.
   */
  void take(long stream, LinkSocket robot) {
    CompletableFuture<LinkSocket> asked = awaited.remove(stream);
    if (asked == null || !asked.complete(robot)) {
      closeQuietly(robot);
    }
  }

  /** It may have come at the last moment. */
  private static void abandon(CompletableFuture<LinkSocket> asked) {
    if (!asked.cancel(false) && !asked.isCompletedExceptionally()) {
      closeQuietly(asked.join());
    }
  }

  @Override
  public void close() {
    isClosed = true;
    pinger.interrupt();
    channel.close();
    awaited.values().forEach(asked -> asked.completeExceptionally(notConnected()));
  }

  private void ping() {
    try {
      while (channel.send(LinkCodec.encode(new Ping()))) {
        Thread.sleep(PING_INTERVAL);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static GatewayException notConnected() {
    return new GatewayException(Reason.GATEWAY_NOT_CONNECTED, "");
  }

  static void closeQuietly(@Nullable AutoCloseable connection) {
    try {
      if (connection != null) {
        connection.close();
      }
    } catch (Exception e) {
      log.debug("A connection could not be closed.", e);
    }
  }
}
