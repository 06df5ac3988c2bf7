package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.TcpRobotLinkFactory;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PairingCode;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Segment;
import org.toqa.sim.Participant;
import org.toqa.sim.VirtualClock;

/** Three daemons round one load, in one world of three times real time; the first one leads. */
final class FormationRig implements AutoCloseable {

  static final long TASK = 7;
  static final double TOLERANCE = 0.05;
  private static final double RADIUS = 0.1275;
  static final Pose LEADER = new Pose(5, 5, 0.3);
  static final Shape SHAPE = Shape.around(3, 0.5, 0.4, RADIUS);

  private static final double SPEED = 3;

  private final Path folder;
  private final @Nullable LinkTls tls;
  private final List<Optional<Fingerprint>> fingerprints = new ArrayList<>();
  private final VirtualClock clock = new VirtualClock(Instant.EPOCH, SPEED);
  private final List<Robot> robots = new ArrayList<>();
  private final Set<Robot> killed = new HashSet<>();
  private final List<FormationServer> servers = new ArrayList<>();
  private final TrueFormation truth = new TrueFormation(SHAPE, RADIUS);

  private record Robot(Daemon daemon) implements Participant {
    @Override
    public void tick(long nanos) {
      daemon.tick(nanos);
    }

    @Override
    public boolean isReady(long nanos) {
      return !daemon.isWaitingForLeader(nanos);
    }
  }

  FormationRig(Path folder) {
    this(folder, null);
  }

  /**
   * @param tls of the server that the robots are paired with; null: the links are not encrypted
   */
  FormationRig(Path folder, @Nullable LinkTls tls) {
    this.folder = folder;
    this.tls = tls;
    List<Pose> places = new ArrayList<>(SHAPE.followersAt(LEADER));
    places.addFirst(LEADER);
    for (int i = 0; i < places.size(); i++) {
      robots.add(open(i, places.get(i)));
    }
    robots.forEach(robot -> clock.add(robot, Chassis.TICK));
    clock.add(truth, Chassis.TICK);
    clock.start();
    robots.forEach(robot -> fingerprints.add(pair(robot.daemon())));
    connectServers();
  }

  /** 0 is the leader. */
  FormationServer server(int robot) {
    return servers.get(robot);
  }

  List<FormationServer> servers() {
    return servers;
  }

  void connectServers() {
    servers.clear();
    for (int i = 0; i < robots.size(); i++) {
      servers.add(new FormationServer(connect(i)));
    }
  }

  /** Orders all to their parts, and the leader to drive. */
  void startFormation(List<Segment> segments) {
    List<Follower> followers = new ArrayList<>();
    for (int i = 1; i < robots.size(); i++) {
      followers.add(
          new Follower(name(i), "127.0.0.1", robots.get(i).daemon().port(), fingerprint(i)));
      server(i)
          .assertAccepted(
              new Follow(
                  1, TASK, name(0), fingerprint(0), SHAPE.offsets().get(i - 1), TOLERANCE, null));
    }
    server(0).assertAccepted(new Lead(1, TASK, TOLERANCE, followers, null));
    server(0).assertAccepted(new Drive(2, TASK, 2, LEADER, segments, segments.size(), true, 0));
  }

  private Optional<Fingerprint> pair(Daemon daemon) {
    if (tls == null) {
      return Optional.empty();
    }
    PairingCode code = PairingCode.parse(daemon.pairingCode().orElseThrow()).orElseThrow();
    PairingResult result =
        new TcpRobotLinkFactory(tls, false)
            .pair(new RobotAddress(daemon.robot(), "127.0.0.1", daemon.port(), null), code);
    return Optional.of(assertInstanceOf(PairingResult.Paired.class, result).robot());
  }

  @Nullable String fingerprint(int robot) {
    return fingerprints.get(robot).map(Fingerprint::hex).orElse(null);
  }

  int port(int robot) {
    return robots.get(robot).daemon().port();
  }

  /** A new connection to the robot, as its server makes it. */
  LinkSocket connect(int robot) {
    try {
      Socket socket =
          new Socket(InetAddress.getLoopbackAddress(), robots.get(robot).daemon().port());
      socket.setTcpNoDelay(true);
      return tls == null
          ? LinkSocket.plain(socket)
          : tls.connect(
              socket,
              LinkTls.LINK,
              (peer, _) -> fingerprints.get(robot).equals(Optional.of(peer)),
              Duration.ofSeconds(5));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * The robot's daemon is gone from one tick to the next, as when its power fails.
   *
   * @return when nothing that it sent could come any more, milliseconds of the world
   */
  long kill(int robot) {
    clock.remove(robots.get(robot));
    killed.add(robots.get(robot));
    close(robots.get(robot).daemon());
    return clock.millis();
  }

  /** Where the bodies really were until now. */
  TrueFormation truth() {
    return truth;
  }

  @Override
  public void close() {
    servers.forEach(FormationServer::close);
    clock.close();
    robots.stream().filter(r -> !killed.contains(r)).forEach(r -> close(r.daemon()));
  }

  static String name(int robot) {
    return String.format(Locale.ROOT, "r%d", robot + 1);
  }

  private Robot open(int robot, Pose start) {
    try {
      return new Robot(
          Daemon.open(
              new AgentConfig(
                  name(robot),
                  InetAddress.getLoopbackAddress(),
                  0,
                  false,
                  folder.resolve(name(robot)),
                  5,
                  0.255,
                  DriveKind.OMNI,
                  Rig.LIMITS,
                  AgentConfig.Following.DEFAULT,
                  new ChassisConfig.Simulated(
                      start,
                      SimulatedBattery.FULL,
                      0.01,
                      robot,
                      1,
                      truth.surroundings(name(robot)))),
              clock,
              clock.nanos(),
              tls != null));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void close(Daemon daemon) {
    try {
      daemon.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
