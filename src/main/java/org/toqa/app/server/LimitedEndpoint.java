package org.toqa.app.server;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.SocketChannel;
import java.time.Duration;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.coyote.Processor;
import org.apache.tomcat.util.net.NioChannel;
import org.apache.tomcat.util.net.NioEndpoint;
import org.apache.tomcat.util.net.SocketWrapperBase;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.AddressBlock;
import org.toqa.app.config.Configuration.Limits;

/**
 * Takes connections, so many of one address and so many of all. Where there are as many, a new one
 * takes the place of one that does nothing for anybody: the one whose request has been coming in
 * for longest, else the one that has been silent for longest; of all, one of the address that has
 * most. So who comes with a whole request is let in, however many are held open. Only where every
 * connection is being answered is the new one closed.
 *
 * <p>Requests that are not complete after a time are ended, however steadily they drip in: Tomcat
 * itself limits only the time between two of their bytes.
 *
 * <p>A connection is ended by the end of its input, which its own thread finds; to close it from
 * another thread would give its buffers away while they are used.
 */
final class LimitedEndpoint extends NioEndpoint {
  private static final Duration SWEEP_PERIOD = Duration.ofMillis(500);

  /** Beyond its limit Tomcat takes no new ones, before which places are found for them here. */
  private static final int RESERVE = 64;

  private final Limits limits;
  private final @Nullable InetAddress proxy;
  private final ReceivedRequests requests = new ReceivedRequests();
  private final AddressCounts addressCounts = new AddressCounts();
  private final AtomicBoolean isToRecount = new AtomicBoolean();
  private Map<SocketWrapperBase<?>, Long> handshakes = Map.of();
  private @Nullable ScheduledFuture<?> sweep;

  /**
   * @param proxy whose connections are not counted by address; null: there is none
   */
  LimitedEndpoint(Limits limits, @Nullable InetAddress proxy) {
    this.limits = limits;
    this.proxy = proxy;
    setMaxConnections(limits.connections() + RESERVE);
  }

  /** What is coming in at its connections. */
  ReceivedRequests requests() {
    return requests;
  }

  @Override
  public void startInternal() throws Exception {
    super.startInternal();
    sweep =
        getUtilityExecutor()
            .scheduleWithFixedDelay(
                this::endSlowRequests,
                SWEEP_PERIOD.toMillis(),
                SWEEP_PERIOD.toMillis(),
                TimeUnit.MILLISECONDS);
  }

  @Override
  public void stopInternal() {
    if (sweep != null) {
      sweep.cancel(false);
    }
    super.stopInternal();
  }

  @Override
  protected boolean setSocketOptions(SocketChannel socket) {
    if (hasPlace(socket)) {
      return super.setSocketOptions(socket);
    }
    destroySocket(socket);
    return false;
  }

  /** Makes one where there is none. */
  private boolean hasPlace(SocketChannel socket) {
    InetAddress address =
        ((InetSocketAddress) socket.socket().getRemoteSocketAddress()).getAddress();
    String block = AddressBlock.of(address.getHostAddress());
    if (isToRecount.getAndSet(false)) {
      // here, where connections are taken, none is between its counting and its place among them
      addressCounts.set(getConnections().stream().map(LimitedEndpoint::block));
    }
    boolean mayBeFullOfOne = addressCounts.add(block) > limits.connectionsPerAddress();
    if (getConnectionCount() <= limits.connections() && (!mayBeFullOfOne || isProxy(address))) {
      return true;
    }
    List<SocketWrapperBase<NioChannel>> open =
        getConnections().stream().filter(LimitedEndpoint::isOpen).toList();
    if (!isProxy(address)) {
      List<SocketWrapperBase<NioChannel>> same =
          open.stream().filter(connection -> block(connection).equals(block)).toList();
      if (same.size() >= limits.connectionsPerAddress()) {
        return endIdlest(same.stream());
      }
    }
    return open.size() < limits.connections() || endIdlest(idleOfFullestAddress(open));
  }

  private boolean isProxy(InetAddress address) {
    return address.equals(proxy);
  }

  private Stream<SocketWrapperBase<NioChannel>> idleOfFullestAddress(
      List<SocketWrapperBase<NioChannel>> open) {
    return open.stream()
        .filter(this::isIdle)
        .collect(Collectors.groupingBy(LimitedEndpoint::block))
        .values()
        .stream()
        .max(Comparator.comparingInt(List::size))
        .stream()
        .flatMap(List::stream);
  }

  private boolean endIdlest(Stream<SocketWrapperBase<NioChannel>> connections) {
    Optional<Idle> idlest =
        connections
            .filter(this::isIdle)
            .map(connection -> new Idle(connection, requests.since(connection)))
            .min(
                Comparator.comparing((Idle idle) -> idle.since().isEmpty())
                    .thenComparingLong(idle -> idle.since().orElse(idle.lastRead())));
    idlest.ifPresent(idle -> endInput(idle.connection()));
    return idlest.isPresent();
  }

  /**
   * A connection at which nothing is answered.
   *
   * @param since when a request began to come in, nanoseconds; empty: none has
   */
  private record Idle(SocketWrapperBase<NioChannel> connection, OptionalLong since) {
    /** Milliseconds since 1970. */
    long lastRead() {
      return ((NioSocketWrapper) connection).getLastRead();
    }
  }

  /** Whether nothing is being answered there: neither a request nor a live stream. */
  private boolean isIdle(SocketWrapperBase<NioChannel> connection) {
    if (requests.since(connection).isPresent()) {
      return true;
    }
    boolean isStream =
        connection.getCurrentProcessor() instanceof Processor waiting && waiting.isAsync();
    return !isStream && !connection.getLock().isLocked();
  }

  private void endSlowRequests() {
    long now = System.nanoTime();
    isToRecount.set(true);
    requests.forgetClosed();
    Map<SocketWrapperBase<?>, Long> unfinished = new HashMap<>();
    for (SocketWrapperBase<NioChannel> connection : getConnections()) {
      OptionalLong since = requests.since(connection);
      if (!connection.getSocket().isHandshakeComplete()) {
        long seen = handshakes.getOrDefault(connection, now);
        unfinished.put(connection, seen);
        since = OptionalLong.of(seen);
      }
      if (since.isPresent() && now - since.getAsLong() > limits.requestTime().toNanos()) {
        endInput(connection);
      }
    }
    handshakes = unfinished;
  }

  private static boolean isOpen(SocketWrapperBase<NioChannel> connection) {
    SocketChannel channel = connection.getSocket().getIOChannel();
    return channel != null && !channel.socket().isInputShutdown();
  }

  private static String block(SocketWrapperBase<NioChannel> connection) {
    String address = connection.getRemoteAddr();
    return address == null ? "" : AddressBlock.of(address);
  }

  private static void endInput(SocketWrapperBase<NioChannel> connection) {
    try {
      connection.getSocket().getIOChannel().shutdownInput();
    } catch (IOException goneMeanwhile) {
      // so it has ended
    }
  }
}
