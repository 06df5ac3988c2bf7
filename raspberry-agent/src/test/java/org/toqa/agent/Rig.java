package org.toqa.agent;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ArmConfig;
import org.toqa.agent.config.Avoidance;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.storage.DataFolder;
import org.toqa.geometry.Pose;
import org.toqa.motion.DriveKind;

/** A real daemon over a simulated body, in time that only the test moves. */
final class Rig implements AutoCloseable {

  static final Pose START = new Pose(2, 3, 0);
  static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);

  private final Path folder;
  private final DriveKind kind;
  private final ChassisConfig config;
  private final UnaryOperator<Chassis> wrapper;
  private final @Nullable ArmConfig arm;
  private final Avoidance avoidance;
  private @Nullable Chassis body;
  private final List<TestServer> servers = new ArrayList<>();
  private long nanos;
  private Daemon daemon;

  Rig(Path folder) {
    this(folder, 0.01);
  }

  Rig(Path folder, double noise) {
    this(folder, new ChassisConfig.Simulated(START, SimulatedBattery.FULL, noise, 7, 1));
  }

  Rig(Path folder, ChassisConfig body) {
    this(folder, body, chassis -> chassis);
  }

  /**
   * @param wrapper what is put between the daemon and its body
   */
  Rig(Path folder, ChassisConfig body, UnaryOperator<Chassis> wrapper) {
    this(folder, DriveKind.OMNI, body, wrapper);
  }

  /**
   * @param wrapper what is put between the daemon and its body
   */
  Rig(Path folder, DriveKind kind, ChassisConfig body, UnaryOperator<Chassis> wrapper) {
    this(folder, kind, body, wrapper, null);
  }

  /** With an arm. */
  Rig(Path folder, ArmConfig arm) {
    this(
        folder,
        DriveKind.OMNI,
        new ChassisConfig.Simulated(START, SimulatedBattery.FULL, 0, 7, 1),
        chassis -> chassis,
        arm);
  }

  Rig(
      Path folder,
      DriveKind kind,
      ChassisConfig body,
      UnaryOperator<Chassis> wrapper,
      @Nullable ArmConfig arm) {
    this(folder, kind, body, wrapper, arm, Avoidance.WEIGHTED_DIRECTIONS);
  }

  /** On two wheels, with four agents. */
  static Rig withFourAgents(Path folder, ChassisConfig body) {
    return new Rig(
        folder, DriveKind.DIFFERENTIAL, body, chassis -> chassis, null, Avoidance.FOUR_AGENTS);
  }

  private Rig(
      Path folder,
      DriveKind kind,
      ChassisConfig body,
      UnaryOperator<Chassis> wrapper,
      @Nullable ArmConfig arm,
      Avoidance avoidance) {
    this.arm = arm;
    this.avoidance = avoidance;
    this.kind = kind;
    this.folder = folder;
    this.config = body;
    this.wrapper = wrapper;
    if (body instanceof ChassisConfig.Simulated simulated
        && simulated.surroundings() instanceof RoundObstacles things) {
      things.follow(this::nanos);
    }
    daemon = open();
  }

  /** The daemon's body. */
  Chassis body() {
    return Objects.requireNonNull(body);
  }

  /** The robot's time. */
  long nanos() {
    return nanos;
  }

  Daemon daemon() {
    return daemon;
  }

  Path folder() {
    return folder;
  }

  AgentConfig config() {
    return config(folder, 0);
  }

  AgentConfig config(Path data, int port) {
    return new AgentConfig(
        "r1",
        InetAddress.getLoopbackAddress(),
        port,
        false,
        data,
        5,
        0.255,
        kind,
        LIMITS,
        AgentConfig.Following.DEFAULT,
        config,
        arm,
        avoidance,
        null);
  }

  /** A server that was greeted and has said nothing yet. */
  TestServer connect() {
    TestServer server = connectWithoutReading();
    server.startReading();
    server.awaitHello();
    return server;
  }

  /** A server that connects and never reads a byte. */
  TestServer connectWithoutReading() {
    TestServer server = new TestServer(this);
    servers.add(server);
    return server;
  }

  boolean isWaitingForServer() {
    return daemon.isWaitingForServer(nanos);
  }

  boolean isWaitingForLeader() {
    return daemon.isWaitingForLeader(nanos);
  }

  /** Time goes on; nobody says anything. */
  void advance(Duration time) {
    long end = nanos + time.toNanos();
    while (nanos < end) {
      nanos += Chassis.TICK.toNanos();
      daemon.tick(nanos);
    }
  }

  /** The daemon hears and answers, but no time passes. */
  void tickWithoutTime() {
    daemon.tick(nanos);
  }

  /** Ends the daemon and starts it anew over the same folder, after time in which nothing ran. */
  void restart() {
    closeDaemon();
    reopen();
  }

  void reopen() {
    nanos += Duration.ofSeconds(30).toNanos();
    daemon = open();
  }

  @Override
  public void close() {
    servers.forEach(TestServer::close);
    closeDaemon();
  }

  void closeDaemon() {
    try {
      daemon.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Daemon open() {
    try {
      DataFolder data = new DataFolder(folder);
      Chassis chassis = wrapper.apply(ChassisFactory.open(config(), folder, nanos));
      body = chassis;
      return Daemon.open(
          config(), () -> Instant.EPOCH.plusNanos(nanos), nanos, false, data, chassis);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
