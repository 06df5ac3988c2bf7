package org.toqa.app.bench;

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
import org.toqa.link.message.DecodeResult;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Segment;

/**
 * The peers of a leading robot: its server, which keeps the link alive, and a follower that is
 * always in its place and notes when the leader's poses come.
 */
final class DaemonPeers implements AutoCloseable {
  private static final long TASK = 5;
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final Pose START = new Pose(2, 1, 0);

  /** In the leader's frame: 1 m behind it. */
  private static final Vec2 OFFSET = new Vec2(-1, 0);

  private static final Duration PING_PERIOD = Duration.ofMillis(500);
  private static final Duration POSE_PERIOD = Duration.ofMillis(200);

  /** Two hours round a circle of radius 5 m, counter-clockwise: 0.25 m/s at 0.05 rad/s. */
  private static final List<Segment> LONG_TRAJECTORY =
      Collections.nCopies(2, new Segment(0.25, 0.05, 3600));

  private final Socket server;
  private final ServerSocket followerSocket;
  private final Queue<Double> poseJitterMillis = new ConcurrentLinkedQueue<>();
  private final Queue<String> refusals = new ConcurrentLinkedQueue<>();
  private final Thread pingThread;

  private DaemonPeers(Socket server, ServerSocket followerSocket) {
    this.server = server;
    this.followerSocket = followerSocket;
    Thread.ofVirtual().name("follower").start(this::answerAsFollower);
    Thread.ofVirtual().name("server").start(this::readAnswers);
    pingThread = Thread.ofVirtual().name("pings").start(this::sendPings);
  }

  /**
   * @throws IOException the daemon does not accept a connection
   */
  static DaemonPeers of(MeasuredDaemon daemon) throws IOException {
    ServerSocket followerSocket = new ServerSocket(0, 1, LOOPBACK);
    return new DaemonPeers(new Socket(LOOPBACK, daemon.port()), followerSocket);
  }

  /**
   * Lets the daemon lead the follower round a circle.
   *
   * @throws IOException the connection to the daemon is lost
   */
  void startDriving() throws IOException {
    ServerMessage.Follower follower =
        new ServerMessage.Follower(
            "r2", LOOPBACK.getHostAddress(), followerSocket.getLocalPort(), null);
    send(new ServerMessage.Lead(1, TASK, 0.05, List.of(follower), null));
    send(
        new ServerMessage.Drive(
            2, TASK, 2, START, LONG_TRAJECTORY, LONG_TRAJECTORY.size(), true, 0));
  }

  /** Discards what was noted so far. */
  void reset() {
    poseJitterMillis.clear();
  }

  /** How far each pose came from 200 ms after the one before, milliseconds, never negative. */
  double[] poseJitterMillis() {
    return poseJitterMillis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /**
   * @throws IOException if the daemon has refused something
   */
  void requireNoRefusals() throws IOException {
    if (!refusals.isEmpty()) {
      throw new IOException("The daemon refused: " + refusals.peek());
    }
  }

  private synchronized void send(ServerMessage message) throws IOException {
    server.getOutputStream().write(LinkCodec.encode(message));
  }

  private void sendPings() {
    try {
      for (long seq = 1_000_000_000; true; seq++) {
        send(new ServerMessage.Ping(seq));
        Thread.sleep(PING_PERIOD);
      }
    } catch (IOException closed) {
      // the connection was closed
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void readAnswers() {
    try {
      LineReader lines = new LineReader(server.getInputStream());
      for (LineReader.Line line = lines.readLine(); line != null; line = lines.readLine()) {
        if (LinkCodec.decodeAgentMessage(line)
            instanceof DecodeResult.Decoded<AgentMessage>(AgentMessage.Reject reject)) {
          refusals.add(reject.reason());
        }
      }
    } catch (IOException closed) {
      // the connection was closed
    }
  }

  private void answerAsFollower() {
    try (Socket leader = followerSocket.accept()) {
      leader.setTcpNoDelay(true);
      leader.getOutputStream().write(LinkCodec.encode(hello()));
      LineReader lines = new LineReader(leader.getInputStream());
      long before = 0;
      for (LineReader.Line line = lines.readLine(); line != null; line = lines.readLine()) {
        ServerMessage.@Nullable LeaderPose pose = pose(line);
        if (pose != null) {
          long now = System.nanoTime();
          if (before != 0) {
            poseJitterMillis.add(Math.abs(now - before - POSE_PERIOD.toNanos()) / 1e6);
          }
          before = now;
          Pose place = pose.pose().compose(new Pose(OFFSET.x(), OFFSET.y(), 0));
          leader
              .getOutputStream()
              .write(
                  LinkCodec.encode(
                      new AgentMessage.FollowerReport(TASK, pose.seq(), place, 0, Mode.FOLLOWING)));
        }
      }
    } catch (IOException closed) {
      // the connection was closed
    }
  }

  private static ServerMessage.@Nullable LeaderPose pose(LineReader.Line line) {
    return LinkCodec.decodeServerMessage(line)
            instanceof DecodeResult.Decoded<ServerMessage>(ServerMessage.LeaderPose pose)
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
        3.5,
        0.255,
        0.8,
        DriveKind.OMNI.word(),
        0,
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
    pingThread.interrupt();
    server.close();
    followerSocket.close();
  }
}
