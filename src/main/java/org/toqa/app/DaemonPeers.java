package org.toqa.app;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.MessageReading;
import org.toqa.link.message.ServerMessage;
import org.toqa.motion.Segment;

/**
 * Whom a leading robot talks to: its server, which keeps the link alive, and a follower that is
 * always in its place and notes when the leader's poses come.
 */
final class DaemonPeers implements AutoCloseable {
  private static final long TASK = 5;
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final Pose START = new Pose(2, 1, 0);
  private static final Vec2 OFFSET = new Vec2(-1, 0);
  private static final Duration PING_EVERY = Duration.ofMillis(500);
  private static final Duration BETWEEN_POSES = Duration.ofMillis(200);

  /** Round and round in a circle of 5 m, for two hours. */
  private static final List<Segment> LONG_WAY =
      Collections.nCopies(2, new Segment(0.25, 0.05, 3600));

  private final Socket server;
  private final ServerSocket followerDoor;
  private final Queue<Double> offBeatMillis = new ConcurrentLinkedQueue<>();
  private final Queue<String> refusals = new ConcurrentLinkedQueue<>();
  private final Thread heartbeat;

  private DaemonPeers(Socket server, ServerSocket followerDoor) {
    this.server = server;
    this.followerDoor = followerDoor;
    Thread.ofVirtual().name("follower").start(this::follow);
    Thread.ofVirtual().name("server").start(this::listen);
    heartbeat = Thread.ofVirtual().name("pings").start(this::ping);
  }

  static DaemonPeers of(MeasuredDaemon daemon) throws IOException {
    ServerSocket followerDoor = new ServerSocket(0, 1, LOOPBACK);
    return new DaemonPeers(new Socket(LOOPBACK, daemon.port()), followerDoor);
  }

  /** Lets the daemon lead the follower round and round. */
  void drive() throws IOException {
    ServerMessage.Follower follower =
        new ServerMessage.Follower(
            "r2", LOOPBACK.getHostAddress(), followerDoor.getLocalPort(), null);
    say(new ServerMessage.Lead(1, TASK, 0.05, List.of(follower)));
    say(new ServerMessage.Drive(2, TASK, 2, START, LONG_WAY, LONG_WAY.size(), true, 0));
  }

  /** What was noted so far does not count. */
  void forget() {
    offBeatMillis.clear();
  }

  /** By how many milliseconds each pose came off the 200 ms after the one before. */
  double[] offBeatMillis() {
    return offBeatMillis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /**
   * @throws IOException if the daemon has refused something
   */
  void mustBeContent() throws IOException {
    if (!refusals.isEmpty()) {
      throw new IOException("The daemon refused: " + refusals.peek());
    }
  }

  private synchronized void say(ServerMessage message) throws IOException {
    server.getOutputStream().write(LinkCodec.line(message));
  }

  private void ping() {
    try {
      for (long seq = 1_000_000_000; true; seq++) {
        say(new ServerMessage.Ping(seq));
        Thread.sleep(PING_EVERY);
      }
    } catch (IOException theEnd) {
      // the connection was closed
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void listen() {
    try {
      LineReader lines = new LineReader(server.getInputStream());
      for (LineReader.Line line = lines.next(); line != null; line = lines.next()) {
        if (LinkCodec.agentMessage(line)
            instanceof MessageReading.Understood<AgentMessage>(AgentMessage.Reject reject)) {
          refusals.add(reject.reason());
        }
      }
    } catch (IOException theEnd) {
      // the connection was closed
    }
  }

  private void follow() {
    try (Socket leader = followerDoor.accept()) {
      leader.setTcpNoDelay(true);
      leader.getOutputStream().write(LinkCodec.line(hello()));
      LineReader lines = new LineReader(leader.getInputStream());
      long before = 0;
      for (LineReader.Line line = lines.next(); line != null; line = lines.next()) {
        ServerMessage.@Nullable LeaderPose pose = pose(line);
        if (pose != null) {
          long now = System.nanoTime();
          if (before != 0) {
            offBeatMillis.add(Math.abs(now - before - BETWEEN_POSES.toNanos()) / 1e6);
          }
          before = now;
          Pose place = pose.pose().compose(new Pose(OFFSET.x(), OFFSET.y(), 0));
          leader
              .getOutputStream()
              .write(
                  LinkCodec.line(
                      new AgentMessage.Keep(TASK, pose.seq(), place, 0, Mode.FOLLOWING)));
        }
      }
    } catch (IOException theEnd) {
      // the connection was closed
    }
  }

  private static ServerMessage.@Nullable LeaderPose pose(LineReader.Line line) {
    return LinkCodec.serverMessage(line)
            instanceof MessageReading.Understood<ServerMessage>(ServerMessage.LeaderPose pose)
        ? pose
        : null;
  }

  private static Hello hello() {
    Pose place = START.compose(new Pose(OFFSET.x(), OFFSET.y(), 0));
    return new Hello(
        AgentMessage.VERSION,
        "r2",
        5,
        0.5,
        0.255,
        true,
        place,
        Mode.FOLLOWING,
        TASK,
        2,
        Role.FOLLOWER,
        0,
        0,
        0,
        1,
        null);
  }

  @Override
  public void close() throws IOException {
    heartbeat.interrupt();
    server.close();
    followerDoor.close();
  }
}
