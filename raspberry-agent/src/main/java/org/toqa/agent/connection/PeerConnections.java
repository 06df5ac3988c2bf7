package org.toqa.agent.connection;

import java.net.InetAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.function.Function;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.access.PeerRole;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.formation.BroadcastTimer;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.DecodeResult.Invalid;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckActed;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.LeaderMessage;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;

/**
 * A daemon's connections: one of the server, one of a leader, and those whose first message has not
 * come yet.
 *
 * <ol>
 *   <li>{@link #start} takes each connection that is accepted; any thread may call it.
 *   <li>{@link #process} hands what was received since the last call to a {@link Handler}, in the
 *       order in which it came. Each connection is sent a hello; its first message shows whose it
 *       is, since a server sends commands and a leader its pose. A newer connection replaces an
 *       older one of the same kind.
 *   <li>{@link #sendToServer} and {@link #answerLeader} never wait, and do nothing where there is
 *       no such connection.
 *   <li>{@link #close} closes all of them.
 * </ol>
 *
 * Times are nanoseconds on the daemon's monotonic clock. For the thread of the ticks, but for
 * {@link #start} and {@link #hasPendingMessages}.
 */
public final class PeerConnections implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(PeerConnections.class);

  private static final long SERVER_SILENT_NANOS = 2_000_000_000;
  private static final int INBOX_CAPACITY = 1_000;
  private static final int MAX_UNIDENTIFIED = 8;

  private final String robot;
  private final BlockingQueue<ConnectionEvent> inbox = new ArrayBlockingQueue<>(INBOX_CAPACITY);
  private final Deque<PeerConnection> unidentified = new ArrayDeque<>();
  private final List<LeaderMessage> unansweredMessages = new ArrayList<>();
  private volatile Runnable messageListener = () -> {};
  private @Nullable PeerConnection server;
  private @Nullable PeerConnection leader;
  private long serverHeardNanos;
  private long leaderHeardNanos;
  private long helloSentNanos;

  /** Decides about peers, and takes what they say; is called by {@link #process} alone. */
  public interface Handler {
    /**
     * What a peer may send now.
     *
     * @param peer null where the link is not encrypted
     */
    PeerRole roleOf(@Nullable Fingerprint peer);

    /** The hello for a connection that has opened. */
    Hello hello();

    /** A connection has turned out to be the server's. */
    void serverConnected();

    void commandReceived(Command command);

    /**
     * The server has stored the end of a drive.
     *
     * @param drive its sequence number
     */
    void doneAcknowledged(long drive);

    /**
     * The server has stored the end of an act.
     *
     * @param act its sequence number
     */
    void actedAcknowledged(long act);

    /** A connection has turned out to be a leader's. */
    void leaderConnected();

    /** It is answered later, see {@link #answerLeader}. */
    void leaderMessageReceived(LeaderMessage message);
  }

  /**
   * @param robot its name, for the log
   * @param nanos the time of the first tick
   */
  public PeerConnections(String robot, long nanos) {
    this.robot = robot;
    this.serverHeardNanos = nanos;
  }

  /**
   * @param listener is run on some thread when something was received that waits for a tick
   */
  public void setMessageListener(Runnable listener) {
    messageListener = listener;
  }

  /** Whether something that was received waits for a tick. */
  public boolean hasPendingMessages() {
    return !inbox.isEmpty();
  }

  /** Whether so many messages have come over a connection that is, or may be, the server's. */
  public boolean hasReceivedFromServer(long messages) {
    return Stream.concat(unidentified.stream(), Stream.ofNullable(server))
        .anyMatch(connection -> connection.received() >= messages);
  }

  /** How many messages the connected server was sent, its hello included; 0: there is none. */
  public long sentToServer() {
    return server == null ? 0 : server.sent();
  }

  /** Reads from a connection from now on. */
  public void start(LinkSocket link) {
    new PeerConnection(robot, link, this::enqueue).start();
  }

  private void enqueue(ConnectionEvent event) throws InterruptedException {
    inbox.put(event);
    messageListener.run();
  }

  public boolean hasLeader() {
    return leader != null;
  }

  /** Whether nothing came from a server for two seconds. */
  public boolean isServerSilent(long nanos) {
    return nanos - serverHeardNanos > SERVER_SILENT_NANOS;
  }

  /**
   * Whether a server is connected that has said nothing for a second, and nothing of it waits to be
   * processed. After two seconds it counts as silent, as a stranger that says nothing does.
   *
   * @param nanos now, nanoseconds on the monotonic clock of {@link #process}
   */
  public boolean isWaitingForServer(long nanos) {
    PeerConnection waiting = server == null ? unidentified.peekLast() : server;
    long silence = nanos - Math.max(serverHeardNanos, helloSentNanos);
    return waiting != null
        && silence > SERVER_SILENT_NANOS / 2
        && silence <= SERVER_SILENT_NANOS
        && waiting.endReason() == null
        && inbox.isEmpty();
  }

  /**
   * Whether a leader is connected whose next pose is overdue, and nothing waits to be processed.
   *
   * @param nanos now, nanoseconds on the monotonic clock of {@link #process}
   */
  public boolean isWaitingForLeader(long nanos) {
    return leader != null
        && nanos - leaderHeardNanos > BroadcastTimer.PERIOD_NANOS + 2 * Chassis.TICK.toNanos()
        && leader.endReason() == null
        && inbox.isEmpty();
  }

  /**
   * Hands on what was received, after closing the connections of peers that are trusted no more.
   *
   * @param nanos now, nanoseconds on the daemon's monotonic clock
   */
  public void process(Handler handler, long nanos) {
    closeUntrusted(handler);
    for (ConnectionEvent event = inbox.poll(); event != null; event = inbox.poll()) {
      switch (event) {
        case ConnectionEvent.Opened(PeerConnection connection) ->
            greet(connection, handler.hello(), nanos);
        case ConnectionEvent.LineReceived(
                PeerConnection connection,
                Decoded(LeaderMessage message)) ->
            handleLeader(connection, message, handler, nanos);
        case ConnectionEvent.LineReceived(PeerConnection connection, Decoded(var message)) ->
            handleServer(connection, message, handler, nanos);
        case ConnectionEvent.LineReceived(
                PeerConnection connection,
                Invalid(long seq, String reason)) -> {
          log.warn("{}: refused a line: {}", robot, reason);
          connection.send(new Reject(seq, reason));
        }
      }
    }
    removeEnded();
  }

  private void greet(PeerConnection connection, Hello hello, long nanos) {
    connection.send(hello);
    helloSentNanos = nanos;
    unidentified.addLast(connection);
    if (unidentified.size() > MAX_UNIDENTIFIED) {
      unidentified.removeFirst().close();
    }
  }

  private void handleServer(
      PeerConnection connection, ServerMessage message, Handler handler, long nanos) {
    PeerRole role = handler.roleOf(connection.peer());
    if (role == PeerRole.LEADER && message instanceof Command command) {
      connection.send(new Reject(command.seq(), "A leader gives no commands."));
      return;
    }
    if (!(role == PeerRole.ANONYMOUS || role == PeerRole.SERVER)) {
      return;
    }
    if (unidentified.remove(connection)) {
      setServer(connection);
      handler.serverConnected();
    }
    if (connection != server) {
      return; // said by a server that was replaced
    }
    serverHeardNanos = nanos;
    switch (message) {
      case AckDone(long drive) -> handler.doneAcknowledged(drive);
      case AckActed(long act) -> handler.actedAcknowledged(act);
      case Command command -> handler.commandReceived(command);
      case LeaderMessage _ -> {} // goes to handleLeader
    }
  }

  private void setServer(PeerConnection connection) {
    if (server != null) {
      log.info("{}: a newer connection replaces the older.", robot);
      server.close();
    }
    server = connection;
  }

  private void handleLeader(
      PeerConnection connection, LeaderMessage message, Handler handler, long nanos) {
    PeerRole role = handler.roleOf(connection.peer());
    if (!(role == PeerRole.ANONYMOUS || role == PeerRole.LEADER)) {
      return;
    }
    if (unidentified.remove(connection)) {
      if (leader != null) {
        leader.close();
      }
      leader = connection;
      handler.leaderConnected();
    }
    if (connection == leader) {
      leaderHeardNanos = nanos;
      handler.leaderMessageReceived(message);
      unansweredMessages.add(message);
    }
  }

  /** Another server was paired, or another leader named: messages of the old one do not count. */
  private void closeUntrusted(Handler handler) {
    unidentified.forEach(connection -> closeUntrusted(connection, handler));
    closeUntrusted(server, handler);
    closeUntrusted(leader, handler);
  }

  private static void closeUntrusted(@Nullable PeerConnection connection, Handler handler) {
    if (connection != null
        && connection.endReason() == null
        && handler.roleOf(connection.peer()) == PeerRole.UNTRUSTED) {
      connection.close();
    }
  }

  private Stream<PeerConnection> all() {
    return Stream.concat(unidentified.stream(), Stream.of(server, leader)).filter(Objects::nonNull);
  }

  private void removeEnded() {
    if (!inbox.isEmpty()) {
      return; // may be the last messages of a connection that has ended
    }
    if (server != null && server.endReason() != null) {
      log.warn("{}: the connection of the server ended: {}.", robot, server.endReason());
      server.close();
      server = null;
    }
    if (leader != null && leader.endReason() != null) {
      log.info("{}: the connection of the leader ended: {}.", robot, leader.endReason());
      leader.close();
      leader = null;
    }
    unidentified.removeIf(connection -> connection.endReason() != null);
  }

  /** Where the connected server, or the gateway before it, is seen to be; empty: there is none. */
  public Optional<InetAddress> serverAddress() {
    return Optional.ofNullable(server).map(PeerConnection::remoteAddress);
  }

  public void sendToServer(AgentMessage message) {
    if (server != null) {
      server.send(message);
    }
  }

  /**
   * Answers the leader's messages of this tick.
   *
   * @param answerTo a message; empty where it is not answered
   */
  public void answerLeader(Function<LeaderMessage, Optional<FollowerReport>> answerTo) {
    if (leader != null) {
      unansweredMessages.stream()
          .flatMap(message -> answerTo.apply(message).stream())
          .forEach(leader::send);
    }
    unansweredMessages.clear();
  }

  @Override
  public void close() {
    all().forEach(PeerConnection::close);
    inbox.forEach(event -> event.connection().close());
  }
}
