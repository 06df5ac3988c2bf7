package org.toqa.agent;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.access.LinkEndpoint;
import org.toqa.agent.access.LinkEndpointConfig;
import org.toqa.agent.access.PeerRole;
import org.toqa.agent.chassis.ArmDrive;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.config.AdHocNetwork;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.connection.PeerConnections;
import org.toqa.agent.control.RobotControl;
import org.toqa.agent.formation.FollowerConnector;
import org.toqa.agent.formation.FormationBroadcasts;
import org.toqa.agent.routing.Babeld;
import org.toqa.agent.storage.DataFolder;
import org.toqa.agent.storage.Journal;
import org.toqa.arm.ArmCommand;
import org.toqa.arm.ArmReading;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.LeaderMessage;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkTls;

/**
 * A robot's daemon: connections, control and body together.
 *
 * <ol>
 *   <li>{@link #open} takes the data folder, finds the body and the journal, and listens.
 *   <li>{@link #tick} is called every {@link Chassis#period}, always by one thread: it exchanges
 *       command and reading with the body, obeys what was received, steers, and reports.
 *   <li>{@link #close}, when no tick is running, ends it in the opposite order.
 * </ol>
 */
public final class Daemon implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(Daemon.class);

  /** A tick that comes later than this moves the reference as if it came then. */
  private static final double LONGEST_STEP_SECONDS = 0.1;

  private final AgentConfig config;
  private final InstantSource clock;
  private final DataFolder folder;
  private final Chassis chassis;
  private final @Nullable Babeld routing;
  private final RobotControl control;
  private final LinkEndpoint endpoint;
  private final PeerConnections connections;
  private final FormationBroadcasts broadcasts;
  private final StateReporter reporter;
  private final PeerConnections.Handler messageHandler = new MessageHandler();

  private int ticks;
  private @Nullable ArmCommand armCommand;
  private ChassisCommand command = ChassisCommand.MoveAt.STANDSTILL;
  private volatile long nanos; // the endpoint's threads read it

  /**
   * @param clock what time it is, for the stamps of reports only
   * @param nanos the time of the ticks to come, nanoseconds on a monotonic clock
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
   * @throws IOException as above
   */
  public static Daemon open(AgentConfig config, InstantSource clock, long nanos, boolean pair)
      throws IOException {
    DataFolder folder = new DataFolder(config.dataDir());
    try {
      Chassis chassis = ChassisFactory.open(config, folder.path(), nanos);
      return open(config, clock, nanos, pair, folder, chassis);
    } catch (IOException e) {
      folder.close();
      throw e;
    }
  }

  /**
   * The same, over this body.
   *
   * @param folder the configuration's
   */
  static Daemon open(
      AgentConfig config,
      InstantSource clock,
      long nanos,
      boolean pair,
      DataFolder folder,
      Chassis chassis)
      throws IOException {
    Babeld routing = null;
    try {
      AdHocNetwork network = config.adHocNetwork();
      if (network != null) {
        routing = Babeld.open(config.name(), network, folder.path());
      }
      return new Daemon(config, clock, nanos, pair, folder, chassis, routing);
    } catch (IOException e) {
      if (routing != null) {
        routing.close();
      }
      chassis.close();
      throw e;
    }
  }

  private Daemon(
      AgentConfig config,
      InstantSource clock,
      long nanos,
      boolean pair,
      DataFolder folder,
      Chassis chassis,
      @Nullable Babeld routing)
      throws IOException {
    this.config = config;
    this.routing = routing;
    this.clock = clock;
    this.nanos = nanos;
    this.folder = folder;
    this.chassis = chassis;
    connections = new PeerConnections(config.name(), nanos);
    reporter = new StateReporter(connections::sendToServer);
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
            connections::start);
    broadcasts =
        new FormationBroadcasts(
            config.name(), new FollowerConnector(endpoint.tls(), config.plainOffLoopback()));
    try {
      control =
          new RobotControl(
              config,
              new Journal(folder.path()),
              chassis.exchange(ChassisCommand.MoveAt.STANDSTILL, nanos),
              endpoint.tls().isPresent(),
              chassis::clearStops,
              chassis.arm().map(ArmDrive::reading).orElse(null));
    } catch (IOException e) {
      endpoint.close();
      throw e;
    }
    log.info("{}: listening on {}.", config.name(), endpoint);
  }

  /** The robot's name. */
  public String robot() {
    return config.name();
  }

  /** How often its body is asked and commanded, while it does not stand. */
  Duration period() {
    return chassis.period();
  }

  /** What its end of the link is known by; empty where that is not encrypted. */
  public Optional<Fingerprint> fingerprint() {
    return endpoint.tls().map(LinkTls::fingerprint);
  }

  /** The port that it listens on. */
  public int port() {
    return endpoint.port();
  }

  /**
   * @param listener gets each pose that the server is told, before it is sent, in the thread that
   *     ticks
   */
  public void setPoseListener(Consumer<Pose> listener) {
    reporter.setPoseListener(listener);
  }

  /** The code that it shows for a server to pair with. */
  public Optional<String> pairingCode() {
    return endpoint.pairingCode();
  }

  /**
   * @param listener is run on some thread when something was received that waits for a tick
   */
  public void setMessageListener(Runnable listener) {
    connections.setMessageListener(listener);
  }

  /** Whether something that was received waits for a tick. */
  public boolean hasPendingMessages() {
    return connections.hasPendingMessages();
  }

  /**
   * Whether so many messages of the server that is connected have come. A world that waits for that
   * is the same on every machine. For the thread of the ticks, as the next one.
   */
  public boolean hasReceivedFromServer(long messages) {
    return connections.hasReceivedFromServer(messages);
  }

  /** How many messages the connected server was sent, its hello included; 0: there is none. */
  public long sentToServer() {
    return connections.sentToServer();
  }

  /** Whether it neither drives nor has to do with a formation, and would not miss some ticks. */
  boolean isAtRest() {
    return ticks == SelfTest.TICKS
        && command.equals(ChassisCommand.MoveAt.STANDSTILL)
        && !connections.hasLeader()
        && broadcasts.isEmpty()
        && control.isAtRest();
  }

  /**
   * Whether a server is connected that has said nothing for a second, and nothing of it waits to be
   * processed. A simulated world that runs server and daemon in one process waits for it then: a
   * slow machine is no lost link. A server that is silent for longer is not waited for.
   *
   * @param now the time of the ticks, nanoseconds
   */
  public boolean isWaitingForServer(long now) {
    return connections.isWaitingForServer(now);
  }

  /**
   * Whether a leader that it follows is connected, its next pose is overdue, and nothing waits to
   * be processed; likewise, until that leader counts as lost.
   *
   * @param now the time of the ticks, nanoseconds
   */
  public boolean isWaitingForLeader(long now) {
    return control.hasLeaderInSight() && connections.isWaitingForLeader(now);
  }

  /**
   * @param now nanoseconds on the monotonic clock of {@link #open}
   */
  public void tick(long now) {
    double seconds = Math.min((now - nanos) / 1e9, LONGEST_STEP_SECONDS);
    nanos = now;
    chassis.setLoad(control.load());
    chassis.setSharedLoad(control.sharedLoad().orElse(null));
    chassis.setAnchor(control.anchor());
    control.update(chassis.exchange(command, now), now / 1e9);
    connections.process(messageHandler, now);
    broadcasts.takeAnswers().forEach(control::handle);
    command = control.drive(seconds, connections.isServerSilent(now));
    chassis.arm().ifPresent(arm -> moveArm(arm, seconds, now));
    connections.answerLeader(control::answerTo);
    broadcasts.update(control.leadOrder(), control.done(), now);
    broadcasts.send(
        control.pose(), control.plannedTwist(), control.isBraking(), clock.millis(), now);
    reporter.report(state(), control.done(), control.acted(), now);
    if (ticks < SelfTest.TICKS && ++ticks == SelfTest.TICKS) {
      SelfTest.logResult(control.report());
    }
  }

  private void moveArm(ArmDrive arm, double seconds, long now) {
    control.orderedLoad().ifPresent(arm::expectLoad);
    ArmReading reading = armCommand == null ? arm.reading() : arm.exchange(armCommand, now);
    armCommand = control.moveArm(seconds, reading);
  }

  private State state() {
    return control
        .report()
        .state(
            clock.millis(),
            Stream.concat(endpoint.rejection().stream(), routingFault().stream()).toList(),
            route().orElse(null));
  }

  private Optional<Fault> routingFault() {
    return routing == null ? Optional.empty() : routing.fault();
  }

  private Optional<NetworkRoute> route() {
    return routing == null
        ? Optional.empty()
        : connections.serverAddress().flatMap(routing::routeTo);
  }

  @Override
  public void close() throws IOException {
    endpoint.close();
    broadcasts.close();
    connections.close();
    chassis.exchange(ChassisCommand.MoveAt.STANDSTILL, nanos);
    chassis.close();
    if (routing != null) {
      routing.close();
    }
    folder.close();
    log.info("{}: ended.", config.name());
  }

  /** What the server and a leader say, in the order in which it came. */
  private final class MessageHandler implements PeerConnections.Handler {

    @Override
    public PeerRole roleOf(@Nullable Fingerprint peer) {
      return endpoint.roleOf(peer);
    }

    @Override
    public Hello hello() {
      return control.report().hello();
    }

    @Override
    public void serverConnected() {
      reporter.restart(state(), control.done(), control.acted(), nanos);
    }

    @Override
    public void commandReceived(Command order) {
      AgentMessage answer = control.execute(order);
      if (answer instanceof Ack && order instanceof Follow follow && follow.fingerprint() != null) {
        Fingerprint.parse(follow.fingerprint()).ifPresent(endpoint::setLeader);
      }
      connections.sendToServer(answer);
    }

    @Override
    public void doneAcknowledged(long drive) {
      control.acknowledgeDone(drive);
    }

    @Override
    public void actedAcknowledged(long act) {
      control.acknowledgeActed(act);
    }

    @Override
    public void leaderConnected() {
      control.leaderConnected();
    }

    @Override
    public void leaderMessageReceived(LeaderMessage message) {
      control.handle(message);
    }
  }
}
