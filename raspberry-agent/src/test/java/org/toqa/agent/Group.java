package org.toqa.agent;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.toqa.agent.chassis.SimulatedPower;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.motion.Segment;
import org.toqa.sim.Participant;
import org.toqa.sim.VirtualClock;

/** Three daemons round one load, in one world of five times real time; the first one leads. */
final class Group implements AutoCloseable {

  static final long TASK = 7;
  static final double TOLERANCE = 0.05;
  static final Pose LEADER = new Pose(5, 5, 0.3);
  static final Shape SHAPE = Shape.around(3, 0.5, 0.4, 0.1275);

  private static final double SPEED = 5;

  private final Path folder;
  private final VirtualClock clock = new VirtualClock(Instant.EPOCH, SPEED);
  private final List<Robot> robots = new ArrayList<>();
  private final Set<Robot> killed = new HashSet<>();
  private final List<GroupServer> servers = new ArrayList<>();

  private record Robot(Daemon daemon) implements Participant {
    @Override
    public void tick(long nanos) {
      daemon.tick(nanos);
    }

    @Override
    public boolean isReady(long nanos) {
      return !daemon.awaitsLeader(nanos);
    }
  }

  Group(Path folder) {
    this.folder = folder;
    List<Pose> places = new ArrayList<>(SHAPE.followersAt(LEADER));
    places.addFirst(LEADER);
    for (int i = 0; i < places.size(); i++) {
      robots.add(open(i, places.get(i)));
    }
    robots.forEach(robot -> clock.add(robot, Daemon.TICK));
    clock.start();
    connectServers();
  }

  /** 0 is the leader. */
  GroupServer server(int robot) {
    return servers.get(robot);
  }

  List<GroupServer> servers() {
    return servers;
  }

  void connectServers() {
    servers.clear();
    robots.forEach(robot -> servers.add(new GroupServer(robot.daemon().port())));
  }

  /** Orders all to their parts, and the leader to drive. */
  void begin(List<Segment> way) {
    List<Follower> followers = new ArrayList<>();
    for (int i = 1; i < robots.size(); i++) {
      followers.add(new Follower(name(i), "127.0.0.1", robots.get(i).daemon().port(), null));
      server(i).accepted(new Follow(1, TASK, name(0), null, SHAPE.offsets().get(i - 1), TOLERANCE));
    }
    server(0).accepted(new Lead(1, TASK, TOLERANCE, followers));
    server(0).accepted(new Drive(2, TASK, 2, LEADER, way, way.size(), true, 0));
  }

  /**
   * The robot's daemon is gone from one tick to the next, as when its power fails.
   *
   * @return when, milliseconds of the world
   */
  long kill(int robot) {
    clock.remove(robots.get(robot));
    long gone = clock.millis();
    killed.add(robots.get(robot));
    close(robots.get(robot).daemon());
    return gone;
  }

  @Override
  public void close() {
    servers.forEach(GroupServer::close);
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
                  Rig.LIMITS,
                  AgentConfig.Following.DEFAULT,
                  new Body.Simulated(start, SimulatedPower.FULL, 0.01, robot, 1)),
              clock,
              clock.nanos()));
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
