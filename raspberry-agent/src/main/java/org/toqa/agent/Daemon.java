package org.toqa.agent;

import java.io.IOException;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.access.LinkEndpoint;
import org.toqa.agent.access.LinkEndpointConfig;
import org.toqa.agent.access.PeerRole;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.connection.ConnectionEvent;
import org.toqa.agent.connection.PeerConnection;
import org.toqa.agent.control.RobotControl;
import org.toqa.agent.firmware.FirmwareChassis;
import org.toqa.agent.firmware.FrameTransport;
import org.toqa.agent.firmware.SerialTransport;
import org.toqa.agent.firmware.SimulatorTransport;
import org.toqa.agent.firmware.SpidevTransport;
import org.toqa.agent.formation.BroadcastTimer;
import org.toqa.agent.formation.FollowerConnector;
import org.toqa.agent.formation.FormationBroadcast;
import org.toqa.agent.storage.DataFolder;
import org.toqa.agent.storage.Journal;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.DecodeResult.Invalid;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.LeaderMessage;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;

/**
 * A robot's daemon: the link's end, the control and the body together.
 *
 * <ol>
 *   <li>{@link #open} takes the data folder, finds the body and the journal, and listens.
 *   <li>{@link #tick} is called every {@link Chassis#TICK}, always by one thread: it exchanges
 *       command and reading with the body, obeys what was heard, reports, and steers.
 *   <li>{@link #close}, when no tick is under way, ends it in the opposite order.
 * </ol>
 */
public final class Daemon implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(Daemon.class);

  private static final long SERVER_SILENT_NANOS = 2_000_000_000;

  /** Half a tick early, since a tick is never quite on time. */
  private static final long STATE_INTERVAL_NANOS = 190_000_000;

  private static final long DONE_INTERVAL_NANOS = 990_000_000;

  /** A tick that comes later than this moves the reference as if it came then. */
  private static final double LONGEST_STEP_SECONDS = 0.1;

  private static final int INBOX_CAPACITY = 1_000;

  /** Connections that have not shown yet whose they are. */
  private static final int MAX_UNIDENTIFIED = 8;

  private final AgentConfig config;
  private final InstantSource clock;
  private final DataFolder folder;
  private final Chassis chassis;
  private final RobotControl control;
  private final BlockingQueue<ConnectionEvent> inbox = new ArrayBlockingQueue<>(INBOX_CAPACITY);
  private final LinkEndpoint endpoint;
  private final FollowerConnector connector;

  private volatile Runnable messageListener = () -> {};
  private int ticks;
  private Twist command = Twist.ZERO;
  private final Deque<PeerConnection> unidentified = new ArrayDeque<>();
  private final List<LeaderMessage> unansweredMessages = new ArrayList<>();
  private final List<FormationBroadcast> endingBroadcasts = new ArrayList<>();
  private @Nullable PeerConnection server;
  private @Nullable PeerConnection leader;
  private @Nullable FormationBroadcast broadcast;
  private long leaderHeardNanos;
  private volatile long nanos; // the door's threads read it
  private long serverHeardNanos;
  private long helloSentNanos;
  private @Nullable State lastState;
  private long lastStateNanos;
  private @Nullable PhaseEnd lastDone;
  private long lastDoneNanos;

  /**
   * @param clock what time it is, for the stamps of reports only
   * @param nanos the time of the ticks to come, on a monotonic clock
   * @throws IOException with one line for people: the port or the data folder is taken or not
   *     usable
   */
  public static Daemon open(AgentConfig config, InstantSource clock, long nanos)
      throws IOException {
    return open(config, clock, nanos, false);
  }

  /**
   * The same, and shows a code for a server to pair with.
   *
   * @param pair false: only where the robot cannot do without a server
   */
  public static Daemon open(AgentConfig config, InstantSource clock, long nanos, boolean pair)
      throws IOException {
    DataFolder folder = new DataFolder(config.dataDir());
    try {
      return open(config, clock, nanos, pair, folder, openChassis(config, folder, nanos));
    } catch (IOException e) {
      folder.close();
      throw e;
    }
  }

  private static Daemon open(
      AgentConfig config,
      InstantSource clock,
      long nanos,
      boolean pair,
      DataFolder folder,
      Chassis chassis)
      throws IOException {
    try {
      return new Daemon(config, clock, nanos, pair, folder, chassis);
    } catch (IOException e) {
      chassis.close();
      throw e;
    }
  }

  private static Chassis openChassis(AgentConfig config, DataFolder folder, long nanos)
      throws IOException {
    return switch (config.chassis()) {
      case ChassisConfig.Simulated body ->
          new SimulatedChassis(
              folder.path().resolve("body"),
              body.start(),
              body.battery(),
              body.noise(),
              body.seed(),
              new RangeSensors(config.footprint() / 2),
              body.surroundings());
      case ChassisConfig.SimulatedFirmware(var socket, var start) ->
          openFirmware(config, new SimulatorTransport(socket), start, nanos);
      case ChassisConfig.Spi(var device, int hertz, int wordDelay) ->
          openFirmware(config, new SpidevTransport(device, hertz, wordDelay), null, nanos);
      case ChassisConfig.Serial(var device, int baud) ->
          openFirmware(config, new SerialTransport(device, baud), null, nanos);
    };
  }

  private static Chassis openFirmware(
      AgentConfig config, FrameTransport transport, @Nullable Pose start, long nanos)
      throws IOException {
    String caption = config.name() + " " + config.address().getHostAddress();
    try {
      return new FirmwareChassis(transport, caption, start, nanos);
    } catch (IOException e) {
      transport.close();
      throw e;
    }
  }

  private Daemon(
      AgentConfig config,
      InstantSource clock,
      long nanos,
      boolean pair,
      DataFolder folder,
      Chassis chassis)
      throws IOException {
    this.config = config;
    this.clock = clock;
    this.nanos = nanos;
    this.serverHeardNanos = nanos;
    this.folder = folder;
    this.chassis = chassis;
    endpoint =
        new LinkEndpoint(
            new LinkEndpointConfig(
                config.name(),
                config.address(),
                config.port(),
                config.plainOffLoopback(),
                folder.path(),
                pair,
                () -> this.nanos),
            this::startConnection);
    connector = new FollowerConnector(endpoint.tls(), config.plainOffLoopback());
    try {
      control =
          new RobotControl(
              config,
              new Journal(folder.path()),
              chassis.exchange(Twist.ZERO, nanos),
              endpoint.tls().isPresent());
    } catch (IOException e) {
      endpoint.close();
      throw e;
    }
    log.info("{}: listening on {}.", config.name(), endpoint);
  }

  public String robot() {
    return config.name();
  }

  /** The port that it listens on. */
  public int port() {
    return endpoint.port();
  }

  /** The code that it shows for a server to pair with. */
  public Optional<String> pairingCode() {
    return endpoint.pairingCode();
  }

  private void startConnection(LinkSocket link) {
    new PeerConnection(config.name(), link, this::enqueue).start();
  }

  private void enqueue(ConnectionEvent inbound) throws InterruptedException {
    inbox.put(inbound);
    messageListener.run();
  }

  /**
   * @param listener is run on some thread when somebody has said something that waits for a tick
   */
  void setMessageListener(Runnable listener) {
    messageListener = listener;
  }

  /** Whether something that somebody said waits for a tick. */
  boolean hasPendingMessages() {
    return !inbox.isEmpty();
  }

  /** Whether it neither drives nor has to do with a formation, and would not miss some ticks. */
  boolean isAtRest() {
    return ticks == SelfTest.TICKS
        && command.equals(Twist.ZERO)
        && leader == null
        && broadcast == null
        && endingBroadcasts.isEmpty()
        && control.isAtRest();
  }

  /**
   * Whether a server is connected that has said nothing for a second, and nothing of it waits to be
   * heard. A simulated world that runs server and daemon in one process waits for it then: a slow
   * machine is no lost link.
   *
   * @param now the time of the ticks
   */
  public boolean isWaitingForServer(long now) {
    PeerConnection waiting = server == null ? unidentified.peekLast() : server;
    return waiting != null
        && waiting.endReason() == null
        && inbox.isEmpty()
        && now - Math.max(serverHeardNanos, helloSentNanos) > SERVER_SILENT_NANOS / 2;
  }

  /**
   * Whether a leader is connected that should have said by now where it is, and nothing waits to be
   * heard; likewise.
   *
   * @param now the time of the ticks
   */
  public boolean isWaitingForLeader(long now) {
    return leader != null
        && leader.endReason() == null
        && inbox.isEmpty()
        && now - leaderHeardNanos > BroadcastTimer.PERIOD_NANOS + 2 * Chassis.TICK.toNanos();
  }

  /**
   * @param now on the monotonic clock of {@link #open}
   */
  public void tick(long now) {
    double seconds = Math.min((now - nanos) / 1e9, LONGEST_STEP_SECONDS);
    nanos = now;
    chassis.setLoad(control.load());
    control.update(chassis.exchange(command, now), now / 1e9);
    processInbox();
    if (broadcast != null) {
      broadcast.takeAnswers().forEach(control::handle);
    }
    command =
        config
            .limits()
            .clampedTwist(control.drive(seconds, now - serverHeardNanos > SERVER_SILENT_NANOS));
    answerLeader();
    updateBroadcasts();
    sendReports();
    if (ticks < SelfTest.TICKS && ++ticks == SelfTest.TICKS) {
      SelfTest.logResult(control.report());
    }
  }

  @Override
  public void close() throws IOException {
    endpoint.close();
    if (broadcast != null) {
      broadcast.close();
    }
    endingBroadcasts.forEach(FormationBroadcast::close);
    Stream.concat(unidentified.stream(), Stream.of(server, leader))
        .filter(Objects::nonNull)
        .forEach(PeerConnection::close);
    inbox.forEach(inbound -> inbound.connection().close());
    chassis.exchange(Twist.ZERO, nanos);
    chassis.close();
    folder.close();
    log.info("{}: ended.", config.name());
  }

  private void processInbox() {
    closeUntrusted();
    for (ConnectionEvent inbound = inbox.poll(); inbound != null; inbound = inbox.poll()) {
      switch (inbound) {
        case ConnectionEvent.Opened(PeerConnection connection) -> sendHello(connection);
        case ConnectionEvent.LineReceived(
                PeerConnection connection,
                Decoded(LeaderMessage message)) ->
            handle(connection, message);
        case ConnectionEvent.LineReceived(PeerConnection connection, Decoded(var message)) ->
            handle(connection, message);
        case ConnectionEvent.LineReceived(
                PeerConnection connection,
                Invalid(long seq, String reason)) -> {
          log.warn("{}: refused a line: {}", config.name(), reason);
          connection.send(new Reject(seq, reason));
        }
      }
    }
    removeEnded();
  }

  /** Whose connection it is shows with its first message: a server commands, a leader tells. */
  private void sendHello(PeerConnection connection) {
    connection.send(control.report().hello());
    helloSentNanos = nanos;
    unidentified.addLast(connection);
    if (unidentified.size() > MAX_UNIDENTIFIED) {
      unidentified.removeFirst().close();
    }
  }

  private void handle(PeerConnection connection, ServerMessage message) {
    PeerRole role = endpoint.roleOf(connection.peer());
    if (role == PeerRole.LEADER && message instanceof Command command) {
      connection.send(new Reject(command.seq(), "A leader gives no commands."));
      return;
    }
    if (!(role == PeerRole.ANONYMOUS || role == PeerRole.SERVER)) {
      return;
    }
    if (unidentified.remove(connection)) {
      setServer(connection);
    }
    if (connection != server) {
      return; // said by a server that was replaced
    }
    serverHeardNanos = nanos;
    switch (message) {
      case AckDone(long drive) -> control.acknowledgeDone(drive);
      case Command order -> execute(order);
      case LeaderMessage _ -> {} // heard elsewhere
    }
  }

  private void execute(Command order) {
    AgentMessage answer = control.execute(order);
    if (answer instanceof Ack && order instanceof Follow follow && follow.fingerprint() != null) {
      Fingerprint.parse(follow.fingerprint()).ifPresent(endpoint::setLeader);
    }
    sendToServer(answer);
    if (order instanceof Resume) {
      chassis.clearFaults();
    }
  }

  private void setServer(PeerConnection connection) {
    if (server != null) {
      log.info("{}: a newer connection replaces the older.", config.name());
      server.close();
    }
    server = connection;
    sendState(state());
    lastDone = control.done().orElse(null);
    lastDoneNanos = nanos;
  }

  private void handle(PeerConnection connection, LeaderMessage message) {
    PeerRole role = endpoint.roleOf(connection.peer());
    if (!(role == PeerRole.ANONYMOUS || role == PeerRole.LEADER)) {
      return;
    }
    if (unidentified.remove(connection)) {
      if (leader != null) {
        leader.close();
      }
      leader = connection;
      control.leaderConnected();
    }
    if (connection == leader) {
      leaderHeardNanos = nanos;
      control.handle(message);
      unansweredMessages.add(message);
    }
  }

  private void answerLeader() {
    if (leader != null) {
      unansweredMessages.stream()
          .flatMap(message -> control.answerTo(message).stream())
          .forEach(leader::send);
    }
    unansweredMessages.clear();
  }

  /** Another server was paired, or another leader named: what the old one still says is void. */
  private void closeUntrusted() {
    Stream.concat(unidentified.stream(), Stream.of(server, leader))
        .filter(Objects::nonNull)
        .filter(connection -> connection.endReason() == null)
        .filter(connection -> endpoint.roleOf(connection.peer()) == PeerRole.UNTRUSTED)
        .forEach(PeerConnection::close);
  }

  private void removeEnded() {
    if (!inbox.isEmpty()) {
      return; // their last words
    }
    if (server != null && server.endReason() != null) {
      log.warn("{}: the connection of the server ended: {}.", config.name(), server.endReason());
      server.close();
      server = null;
    }
    if (leader != null && leader.endReason() != null) {
      log.info("{}: the connection of the leader ended: {}.", config.name(), leader.endReason());
      leader.close();
      leader = null;
    }
    unidentified.removeIf(guest -> guest.endReason() != null);
  }

  /** Tells the followers, if there are any, where this leader is, or that the formation ends. */
  private void updateBroadcasts() {
    Lead order = control.leadOrder().orElse(null);
    if (broadcast != null && !broadcast.order().equals(order)) {
      endBroadcast(broadcast);
      broadcast = null;
    }
    if (broadcast == null && order != null) {
      broadcast = new FormationBroadcast(config.name(), order, connector, nanos);
    }
    if (broadcast != null) {
      broadcast.sendPose(
          control.pose(), control.plannedTwist(), control.isBraking(), clock.millis(), nanos);
    }
    endingBroadcasts.forEach(ending -> ending.sendEnd(nanos));
    endingBroadcasts.stream()
        .filter(ending -> ending.isOver(nanos))
        .forEach(FormationBroadcast::close);
    endingBroadcasts.removeIf(ending -> ending.isOver(nanos));
  }

  /** A formation that is not at its goal has no end: its followers stop, and ask their server. */
  private void endBroadcast(FormationBroadcast over) {
    boolean isAtGoal =
        control
            .done()
            .filter(done -> done.phase() == 2 && Objects.equals(done.task(), over.order().task()))
            .isPresent();
    if (isAtGoal) {
      over.beginEnd(nanos);
      endingBroadcasts.add(over);
    } else {
      over.close();
    }
  }

  private void sendReports() {
    State state = state();
    if (nanos - lastStateNanos >= STATE_INTERVAL_NANOS || hasChanged(state)) {
      sendState(state);
    }
    PhaseEnd done = control.done().orElse(null);
    if (done != null && (!done.equals(lastDone) || nanos - lastDoneNanos >= DONE_INTERVAL_NANOS)) {
      sendToServer(new Done(done.task(), done.phase(), done.drive()));
      lastDoneNanos = nanos;
    }
    lastDone = done;
  }

  private State state() {
    return control
        .report()
        .state(clock.millis(), endpoint.rejection().map(List::of).orElse(List.of()));
  }

  private void sendState(State state) {
    sendToServer(state);
    lastState = state;
    lastStateNanos = nanos;
  }

  private boolean hasChanged(State state) {
    State before = lastState;
    return before == null
        || state.mode() != before.mode()
        || state.localised() != before.localised()
        || state.drive() != before.drive()
        || state.segment() != before.segment()
        || state.released() != before.released()
        || state.phase() != before.phase()
        || !Objects.equals(state.task(), before.task())
        || !errorCodes(state).equals(errorCodes(before));
  }

  private static List<String> errorCodes(State state) {
    return state.errors().stream().map(Fault::code).toList();
  }

  private void sendToServer(AgentMessage message) {
    if (server != null) {
      server.send(message);
    }
  }
}
