package org.toqa.agent;

import java.io.IOException;
import java.time.Duration;
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
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.door.Door;
import org.toqa.agent.door.DoorConfig;
import org.toqa.agent.door.PeerRole;
import org.toqa.agent.spi.FirmwareChassis;
import org.toqa.agent.spi.FrameTransport;
import org.toqa.agent.spi.SerialTransport;
import org.toqa.agent.spi.SimulatorTransport;
import org.toqa.agent.spi.SpidevTransport;
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
import org.toqa.link.message.MessageReading.Refused;
import org.toqa.link.message.MessageReading.Understood;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.FromLeader;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;

/**
 * A robot's daemon: the link's end, the control and the body together.
 *
 * <ol>
 *   <li>{@link #open} takes the data folder, finds the body and the journal, and listens.
 *   <li>{@link #tick} is called every {@link #TICK}, always by one thread: it exchanges command and
 *       reading with the body, obeys what was heard, reports, and steers.
 *   <li>{@link #close}, when no tick is under way, ends it in the opposite order.
 * </ol>
 */
public final class Daemon implements AutoCloseable {

  public static final Duration TICK = Duration.ofMillis(20);

  private static final Logger log = LoggerFactory.getLogger(Daemon.class);

  private static final long SILENCE_NANOS = 2_000_000_000;

  /** Half a tick early, since a tick is never quite on time. */
  private static final long STATE_NANOS = 190_000_000;

  private static final long DONE_NANOS = 990_000_000;

  /** A tick that comes later than this moves the reference as if it came then. */
  private static final double LONGEST_STEP_SECONDS = 0.1;

  private static final int INBOX = 1_000;

  /** Connections that have not shown yet whose they are. */
  private static final int MOST_GUESTS = 8;

  private final AgentConfig config;
  private final InstantSource clock;
  private final DataFolder folder;
  private final Chassis chassis;
  private final RobotControl control;
  private final BlockingQueue<Inbound> inbox = new ArrayBlockingQueue<>(INBOX);
  private final Door door;
  private final Dialer dialer;

  private volatile Runnable heard = () -> {};
  private int ticks;
  private Twist command = Twist.ZERO;
  private final Deque<ServerConnection> guests = new ArrayDeque<>();
  private final List<FromLeader> unanswered = new ArrayList<>();
  private final List<Broadcast> endings = new ArrayList<>();
  private @Nullable ServerConnection server;
  private @Nullable ServerConnection leader;
  private @Nullable Broadcast broadcast;
  private long leaderHeardNanos;
  private volatile long nanos; // the door's threads read it
  private long heardNanos;
  private long welcomedNanos;
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
      return open(config, clock, nanos, pair, folder, chassis(config, folder, nanos));
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

  private static Chassis chassis(AgentConfig config, DataFolder folder, long nanos)
      throws IOException {
    return switch (config.chassis()) {
      case Body.Simulated body ->
          new SimulatedChassis(
              folder.path().resolve("body"),
              body.start(),
              body.power(),
              body.noise(),
              body.seed(),
              new RangeSensors(config.footprint() / 2),
              body.surroundings());
      case Body.SimulatedFirmware(var socket, var start) ->
          firmware(config, new SimulatorTransport(socket), start, nanos);
      case Body.Spi(var device, int hertz, int wordDelay) ->
          firmware(config, new SpidevTransport(device, hertz, wordDelay), null, nanos);
      case Body.Serial(var device, int baud) ->
          firmware(config, new SerialTransport(device, baud), null, nanos);
    };
  }

  private static Chassis firmware(
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
    this.heardNanos = nanos;
    this.folder = folder;
    this.chassis = chassis;
    door =
        new Door(
            new DoorConfig(
                config.name(),
                config.address(),
                config.port(),
                config.plainOffLoopback(),
                folder.path(),
                pair,
                () -> this.nanos),
            this::greetLater);
    dialer = new Dialer(door.tls(), config.plainOffLoopback());
    try {
      control =
          new RobotControl(
              config,
              new Journal(folder.path()),
              chassis.exchange(Twist.ZERO, nanos),
              door.tls().isPresent());
    } catch (IOException e) {
      door.close();
      throw e;
    }
    log.info("{}: listening on {}.", config.name(), door);
  }

  public String robot() {
    return config.name();
  }

  /** The port that it listens on. */
  public int port() {
    return door.port();
  }

  /** The code that it shows for a server to pair with. */
  public Optional<String> pairingCode() {
    return door.code();
  }

  private void greetLater(LinkSocket link) {
    new ServerConnection(config.name(), link, this::hearLater).start();
  }

  private void hearLater(Inbound inbound) throws InterruptedException {
    inbox.put(inbound);
    heard.run();
  }

  /**
   * @param listener is run on some thread when somebody has said something that waits for a tick
   */
  void onHeard(Runnable listener) {
    heard = listener;
  }

  /** Whether something that somebody said waits for a tick. */
  boolean hasHeard() {
    return !inbox.isEmpty();
  }

  /** Whether it neither drives nor has to do with a formation, and would not miss some ticks. */
  boolean isAtRest() {
    return ticks == SelfTest.TICKS
        && command.equals(Twist.ZERO)
        && leader == null
        && broadcast == null
        && endings.isEmpty()
        && control.isAtRest();
  }

  /**
   * Whether a server is connected that has said nothing for a second, and nothing of it waits to be
   * heard. A simulated world that runs server and daemon in one process waits for it then: a slow
   * machine is no lost link.
   *
   * @param now the time of the ticks
   */
  public boolean awaitsServer(long now) {
    ServerConnection waiting = server == null ? guests.peekLast() : server;
    return waiting != null
        && waiting.ended() == null
        && inbox.isEmpty()
        && now - Math.max(heardNanos, welcomedNanos) > SILENCE_NANOS / 2;
  }

  /**
   * Whether a leader is connected that should have said by now where it is, and nothing waits to be
   * heard; likewise.
   *
   * @param now the time of the ticks
   */
  public boolean awaitsLeader(long now) {
    return leader != null
        && leader.ended() == null
        && inbox.isEmpty()
        && now - leaderHeardNanos > BroadcastPace.PERIOD_NANOS + 2 * TICK.toNanos();
  }

  /**
   * @param now on the monotonic clock of {@link #open}
   */
  public void tick(long now) {
    double seconds = Math.min((now - nanos) / 1e9, LONGEST_STEP_SECONDS);
    nanos = now;
    chassis.carries(control.load());
    control.sense(chassis.exchange(command, now), now / 1e9);
    hear();
    if (broadcast != null) {
      broadcast.answers().forEach(control::heard);
    }
    command = config.limits().within(control.drive(seconds, now - heardNanos > SILENCE_NANOS));
    answerLeader();
    lead();
    report();
    if (ticks < SelfTest.TICKS && ++ticks == SelfTest.TICKS) {
      SelfTest.tell(control.report());
    }
  }

  @Override
  public void close() throws IOException {
    door.close();
    if (broadcast != null) {
      broadcast.close();
    }
    endings.forEach(Broadcast::close);
    Stream.concat(guests.stream(), Stream.of(server, leader))
        .filter(Objects::nonNull)
        .forEach(ServerConnection::close);
    inbox.forEach(inbound -> inbound.connection().close());
    chassis.exchange(Twist.ZERO, nanos);
    chassis.close();
    folder.close();
    log.info("{}: ended.", config.name());
  }

  private void hear() {
    dropDistrusted();
    for (Inbound inbound = inbox.poll(); inbound != null; inbound = inbox.poll()) {
      switch (inbound) {
        case Inbound.Opened(ServerConnection connection) -> greet(connection);
        case Inbound.Heard(ServerConnection connection, Understood(FromLeader message)) ->
            hear(connection, message);
        case Inbound.Heard(ServerConnection connection, Understood(var message)) ->
            hear(connection, message);
        case Inbound.Heard(ServerConnection connection, Refused(long seq, String reason)) -> {
          log.warn("{}: refused a line: {}", config.name(), reason);
          connection.send(new Reject(seq, reason));
        }
      }
    }
    dropEnded();
  }

  /** Whose connection it is shows with its first message: a server commands, a leader tells. */
  private void greet(ServerConnection connection) {
    connection.send(control.report().hello());
    welcomedNanos = nanos;
    guests.addLast(connection);
    if (guests.size() > MOST_GUESTS) {
      guests.removeFirst().close();
    }
  }

  private void hear(ServerConnection connection, ServerMessage message) {
    PeerRole role = door.roleOf(connection.peer());
    if (role == PeerRole.LEADER && message instanceof Command command) {
      connection.send(new Reject(command.seq(), "A leader gives no commands."));
      return;
    }
    if (!(role == PeerRole.ANYBODY || role == PeerRole.SERVER)) {
      return;
    }
    if (guests.remove(connection)) {
      serve(connection);
    }
    if (connection != server) {
      return; // said by a server that was replaced
    }
    heardNanos = nanos;
    switch (message) {
      case AckDone(long drive) -> control.acknowledged(drive);
      case Command order -> obey(order);
      case FromLeader _ -> {} // heard elsewhere
    }
  }

  private void obey(Command order) {
    AgentMessage answer = control.obey(order);
    if (answer instanceof Ack && order instanceof Follow follow && follow.fingerprint() != null) {
      Fingerprint.parse(follow.fingerprint()).ifPresent(door::expectLeader);
    }
    say(answer);
    if (order instanceof Resume) {
      chassis.clearFaults();
    }
  }

  private void serve(ServerConnection connection) {
    if (server != null) {
      log.info("{}: a newer connection replaces the older.", config.name());
      server.close();
    }
    server = connection;
    tellState(state());
    lastDone = control.done().orElse(null);
    lastDoneNanos = nanos;
  }

  private void hear(ServerConnection connection, FromLeader message) {
    PeerRole role = door.roleOf(connection.peer());
    if (!(role == PeerRole.ANYBODY || role == PeerRole.LEADER)) {
      return;
    }
    if (guests.remove(connection)) {
      if (leader != null) {
        leader.close();
      }
      leader = connection;
      control.leaderConnected();
    }
    if (connection == leader) {
      leaderHeardNanos = nanos;
      control.heard(message);
      unanswered.add(message);
    }
  }

  private void answerLeader() {
    if (leader != null) {
      unanswered.stream()
          .flatMap(message -> control.answer(message).stream())
          .forEach(leader::send);
    }
    unanswered.clear();
  }

  /** Another server was paired, or another leader named: what the old one still says is void. */
  private void dropDistrusted() {
    Stream.concat(guests.stream(), Stream.of(server, leader))
        .filter(Objects::nonNull)
        .filter(connection -> connection.ended() == null)
        .filter(connection -> door.roleOf(connection.peer()) == PeerRole.NOBODY)
        .forEach(ServerConnection::close);
  }

  private void dropEnded() {
    if (!inbox.isEmpty()) {
      return; // their last words
    }
    if (server != null && server.ended() != null) {
      log.warn("{}: the connection of the server ended: {}.", config.name(), server.ended());
      server.close();
      server = null;
    }
    if (leader != null && leader.ended() != null) {
      log.info("{}: the connection of the leader ended: {}.", config.name(), leader.ended());
      leader.close();
      leader = null;
    }
    guests.removeIf(guest -> guest.ended() != null);
  }

  /** Tells the followers, if there are any, where this leader is, or that the formation ends. */
  private void lead() {
    Lead order = control.leading().orElse(null);
    if (broadcast != null && !broadcast.order().equals(order)) {
      endBroadcast(broadcast);
      broadcast = null;
    }
    if (broadcast == null && order != null) {
      broadcast = new Broadcast(config.name(), order, dialer, nanos);
    }
    if (broadcast != null) {
      broadcast.tell(control.pose(), control.planned(), control.isBraking(), clock.millis(), nanos);
    }
    endings.forEach(ending -> ending.tellEnd(nanos));
    endings.stream().filter(ending -> ending.isOver(nanos)).forEach(Broadcast::close);
    endings.removeIf(ending -> ending.isOver(nanos));
  }

  /** A formation that is not at its goal has no end: its followers stop, and ask their server. */
  private void endBroadcast(Broadcast over) {
    boolean isAtGoal =
        control
            .done()
            .filter(done -> done.phase() == 2 && Objects.equals(done.task(), over.order().task()))
            .isPresent();
    if (isAtGoal) {
      over.end(nanos);
      endings.add(over);
    } else {
      over.close();
    }
  }

  private void report() {
    State state = state();
    if (nanos - lastStateNanos >= STATE_NANOS || isChange(state)) {
      tellState(state);
    }
    PhaseEnd done = control.done().orElse(null);
    if (done != null && (!done.equals(lastDone) || nanos - lastDoneNanos >= DONE_NANOS)) {
      say(new Done(done.task(), done.phase(), done.drive()));
      lastDoneNanos = nanos;
    }
    lastDone = done;
  }

  private State state() {
    return control.report().state(clock.millis(), door.refused().map(List::of).orElse(List.of()));
  }

  private void tellState(State state) {
    say(state);
    lastState = state;
    lastStateNanos = nanos;
  }

  private boolean isChange(State state) {
    State before = lastState;
    return before == null
        || state.mode() != before.mode()
        || state.localised() != before.localised()
        || state.drive() != before.drive()
        || state.segment() != before.segment()
        || state.released() != before.released()
        || state.phase() != before.phase()
        || !Objects.equals(state.task(), before.task())
        || !codes(state).equals(codes(before));
  }

  private static List<String> codes(State state) {
    return state.errors().stream().map(Fault::code).toList();
  }

  private void say(AgentMessage message) {
    if (server != null) {
      server.send(message);
    }
  }
}
