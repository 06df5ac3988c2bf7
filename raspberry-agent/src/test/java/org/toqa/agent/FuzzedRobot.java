package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.config.ArmConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.arm.ArmAction;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.DecodeResult;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.DecodeResult.Invalid;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckActed;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.FormationEnd;
import org.toqa.link.message.ServerMessage.Frame;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.LeaderMessage;
import org.toqa.link.message.ServerMessage.LeaderPose;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Segment;
import org.toqa.testbed.LineFuzzer;

/**
 * A daemon that hears fuzzed lines of a server and of a leader. It is checked by the rules of
 * {@code docs/robot-link.md}: each line is answered as it deserves, the body moves only after a
 * legal order with released segments or a legal place beside a leader, and never too fast.
 */
final class FuzzedRobot implements AutoCloseable {

  private static final long TASK = 5;

  /** Nobody listens there: what the robot is told to lead is not found. */
  private static final Follower NOBODY = new Follower("r2", "127.0.0.1", 1, null);

  /** Above that a robot takes but a few commands more, which no server ever comes to. */
  private static final long LARGEST_SEQ = 1L << 52;

  /** The pings by which the test waits for answers have numbers of their own. */
  private static final long FIRST_PING = 1_000_000_000;

  private static final long LAST_PING = FIRST_PING + 10_000_000;

  private final LineFuzzer fuzzer;
  private final Count count;
  private final MotionRecorder witness = new MotionRecorder();
  private final long seed;
  private final Rig rig;
  private final TestServer server;
  private final TestServer leader;
  private int answersSeen;
  private int statesSeen;
  private long lastSeq;
  private long leaderSeq;
  private boolean canMove;
  private @Nullable Pose lastLocated;

  /** What became of the lines. */
  static final class Count {
    private long lines;
    private long read;
    private long obeyed;
    private long driven;

    long lines() {
      return lines;
    }

    long obeyed() {
      return obeyed;
    }

    @Override
    public String toString() {
      return "%,d could be read, %,d were obeyed, %,d of them drives and places"
          .formatted(read, obeyed, driven);
    }
  }

  FuzzedRobot(Path folder, long seed, Count count) {
    this.seed = seed;
    this.count = count;
    fuzzer = new LineFuzzer(seed);
    rig =
        new Rig(
            folder,
            DriveKind.OMNI,
            new ChassisConfig.Simulated(Rig.START, SimulatedBattery.FULL, 0, 7, 1, witness),
            chassis -> chassis,
            new ArmConfig(ArmTest.ARM, null));
    server = rig.connect();
    server.synchronise();
    leader = rig.connect();
    leader.synchroniseAsLeader();
  }

  /** Whether a line has used up the numbers of its server. */
  boolean isOutOfNumbers() {
    return lastSeq > LARGEST_SEQ;
  }

  /** Hears so many lines at once, and lives on for a while. */
  void receiveLines(int lines, Duration time) {
    List<byte[]> ofServer = new ArrayList<>();
    List<byte[]> ofLeader = new ArrayList<>();
    State now = server.state();
    List<byte[]> correct = correctLines(now);
    List<byte[]> correctOfLeader = correctLinesOfLeader(now);
    while (ofServer.size() + ofLeader.size() < lines) {
      boolean isOfLeader = fuzzer.pick(List.of(true, false, false, false));
      byte[] line = fuzzer.next(isOfLeader ? correctOfLeader : correct);
      if (isForThisMachine(line)) {
        (isOfLeader ? ofLeader : ofServer).add(line);
      }
    }
    count.lines += lines;
    leader.send(joined(ofLeader));
    leader.synchroniseAsLeader();
    server.send(joined(ofServer));
    check(ofServer, answers());
    rig.advance(time);
    checkMotion();
  }

  /** A drive or a place ends, a hold too, and the body is stopped. */
  void bringToStandstill() {
    server.assertAccepted(new Cancel(++lastSeq, server.state().task()));
    server.assertAccepted(new Cancel(++lastSeq, null));
    server.assertAccepted(new Resume(++lastSeq));
    rig.advance(Duration.ofSeconds(2));
    answers();
    assertEquals(0, server.state().drive());
    witness.takeMoved();
    canMove = false;
    lastLocated = null;
  }

  @Override
  public void close() {
    rig.close();
  }

  /** What a server and a leader may well say to the robot as it is. */
  private List<byte[]> correctLines(State now) {
    long seq = lastSeq + 1;
    List<Segment> segments = List.of(new Segment(0.3, 0, 1), new Segment(0.2, 0.5, 1));
    Pose near = new Pose(now.pose().x() + 0.02, now.pose().y(), now.pose().theta());
    return Stream.of(
            new Drive(seq, TASK, 1, now.pose(), segments, 1, true, 2.5),
            new Drive(seq + 1, null, 0, near, segments, 2, true, 0),
            new Extend(seq + 2, now.drive(), now.released(), segments, now.released() + 1, false),
            new Release(seq + 3, now.drive(), now.released() + 1),
            new Lead(seq + 4, TASK, 0.05, List.of(NOBODY), null),
            new Follow(seq + 5, TASK, "r9", null, new Vec2(-0.5, 0), 0.05, null),
            new Act(seq + 6, TASK, 1, ArmAction.PICK, Frame.ROBOT, new Vec2(0.4, 0.1), 1),
            new Act(seq + 6, TASK, 2, ArmAction.PLACE, Frame.MAP, now.pose().position(), 1),
            new Hold(seq + 6),
            new Resume(seq + 7),
            new Clear(seq + 8, List.of("STOP_EDGE")),
            new Cancel(seq + 8, now.task()),
            new Locate(seq + 9, near),
            new Ping(seq + 10),
            new AckDone(now.drive()),
            new AckActed(lastSeq))
        .map(FuzzedRobot::lineOf)
        .toList();
  }

  private List<byte[]> correctLinesOfLeader(State now) {
    Pose ahead = now.pose().compose(new Pose(0.52, 0, 0));
    return Stream.of(
            new LeaderPose(TASK, ++leaderSeq, 0, ahead, new Speed(0.2, 0)),
            new LeaderPose(TASK, ++leaderSeq, 0, ahead, new Speed(0, 0)),
            new LeaderPose(TASK, ++leaderSeq, 0, ahead, new Speed(0.8, 6)),
            new FormationEnd(TASK))
        .map(FuzzedRobot::lineOf)
        .toList();
  }

  /** A robot that is told to lead really connects to whom it is told. */
  private static boolean isForThisMachine(byte[] line) {
    return !(read(line) instanceof Decoded<ServerMessage>(Lead lead))
        || lead.followers().stream()
            .allMatch(f -> f.host().equals(NOBODY.host()) && f.port() == NOBODY.port());
  }

  private void check(List<byte[]> lines, List<AgentMessage> answers) {
    Iterator<AgentMessage> next = answers.iterator();
    for (byte[] line : lines) {
      switch (read(line)) {
        case Invalid<ServerMessage>(long seq, String _) ->
            assertEquals(seq, assertInstanceOf(Reject.class, next.next(), () -> about(line)).seq());
        case Decoded<ServerMessage>(Command command) -> {
          count.read++;
          check(command, next.next(), line);
        }
        case Decoded<ServerMessage>(AckDone _),
            Decoded<ServerMessage>(AckActed _),
            Decoded<ServerMessage>(LeaderMessage _) ->
            count.read++;
      }
    }
    assertTrue(!next.hasNext(), () -> "one answer too many, seed " + seed);
  }

  private void check(Command command, AgentMessage answer, byte[] line) {
    switch (answer) {
      case Reject(long seq, String reason) -> {
        assertEquals(command.seq(), seq, () -> about(line));
        assertTrue(!reason.isBlank(), () -> about(line));
      }
      case Ack(long seq) -> {
        assertEquals(command.seq(), seq, () -> about(line));
        if (!(command instanceof Ping) && seq > lastSeq) {
          lastSeq = seq;
          count.obeyed++;
          recordObeyed(command, line);
        }
      }
      default -> throw new AssertionError(about(line) + " was answered by " + answer);
    }
  }

  private void recordObeyed(Command command, byte[] line) {
    switch (command) {
      case Drive drive -> {
        count.driven++;
        assertTrue(isLegal(drive), () -> about(line));
        canMove |= drive.released() > 0;
      }
      case Extend extend -> {
        assertTrue(hasOnlyLegalSegments(extend.segments()), () -> about(line));
        canMove |= extend.released() > 0;
      }
      case Release release -> canMove |= release.released() > 0;
      case Room room -> assertTrue(room.left() <= 1 && room.right() <= 1, () -> about(line));
      case Follow follow -> {
        count.driven++;
        assertTrue(follow.tolerance() > 0 && follow.tolerance() <= 0.5, () -> about(line));
        assertTrue(follow.offset().norm() <= 50, () -> about(line));
        canMove = true;
      }
      case Act act -> {
        assertTrue(act.target().norm() <= 150_000 && act.load() >= 0, () -> about(line));
        assertTrue(act.phase() >= 1 && act.phase() <= 3, () -> about(line));
      }
      case Locate locate -> lastLocated = locate.pose();
      case Clear _ -> throw new AssertionError("nothing stops it, but " + about(line));
      case Lead _, Hold _, Resume _, Cancel _, Ping _ -> {}
    }
  }

  private boolean isLegal(Drive drive) {
    Pose pose = lastLocated == null ? server.state().pose() : lastLocated;
    return drive.phase() >= 0
        && drive.phase() <= 3
        && (drive.task() == null) == (drive.phase() == 0)
        && drive.released() >= 0
        && drive.released() <= drive.segments().size()
        && drive.start().distanceTo(pose) < 0.1001
        && Math.toDegrees(Math.abs(Angles.difference(drive.start().theta(), pose.theta()))) < 10.001
        && hasOnlyLegalSegments(drive.segments());
  }

  private static boolean hasOnlyLegalSegments(List<Segment> segments) {
    return segments.stream()
        .allMatch(
            s ->
                s.t() > 0
                    && s.t() <= 3_600
                    && Math.abs(s.v()) < Rig.LIMITS.speed() + 1e-6
                    && Math.abs(s.w()) < Rig.LIMITS.turnRate() + 1e-6);
  }

  private void checkMotion() {
    server.received(State.class).stream()
        .skip(statesSeen)
        .map(State::arm)
        .filter(Objects::nonNull)
        .forEach(
            arm ->
                assertTrue(
                    ArmTest.ARM.allows(arm.joints()), () -> arm.joints() + ", seed " + seed));
    statesSeen = server.received(State.class).size();
    double moved = witness.takeMoved();
    assertTrue(canMove || moved < 1e-6, () -> "moved without an order, seed " + seed);
    assertTrue(
        witness.fastest() <= 1.05 * Rig.LIMITS.speed(),
        () -> "drove %.3f m/s, seed %d".formatted(witness.fastest(), seed));
    assertTrue(
        witness.fastestTurn() <= 1.05 * Rig.LIMITS.turnRate(),
        () -> "turned %.3f rad/s, seed %d".formatted(witness.fastestTurn(), seed));
  }

  /** What was answered since the last time. */
  private List<AgentMessage> answers() {
    List<AgentMessage> all =
        server.received().stream().filter(FuzzedRobot::isAnswerToALine).toList();
    List<AgentMessage> fresh = all.subList(answersSeen, all.size());
    answersSeen = all.size();
    return fresh;
  }

  private static boolean isAnswerToALine(AgentMessage message) {
    return message instanceof Reject
        || (message instanceof Ack(long seq) && !(seq >= FIRST_PING && seq < LAST_PING));
  }

  private String about(byte[] line) {
    return "%s, seed %d".formatted(new String(line, StandardCharsets.UTF_8), seed);
  }

  private static DecodeResult<ServerMessage> read(byte[] line) {
    return LinkCodec.decodeServerMessage(
        line.length < LinkCodec.MAX_LINE_BYTES
            ? new LineReader.Text(line)
            : new LineReader.TooLong(line.length + 1L));
  }

  private static byte[] lineOf(ServerMessage message) {
    byte[] line = LinkCodec.encode(message);
    return Arrays.copyOf(line, line.length - 1);
  }

  private static byte[] joined(List<byte[]> lines) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] line : lines) {
      all.writeBytes(line);
      all.write('\n');
    }
    return all.toByteArray();
  }
}
