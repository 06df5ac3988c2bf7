package org.toqa.link.message;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonSubTypes.Type;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.Nulls;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.ArmAction;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.FreeZone;
import org.toqa.motion.Segment;

/**
 * What a robot is sent: by the server, and in a formation by its leader. Every {@link Command} of
 * the server has a sequence number that rises also over restarts of the server; the robot answers
 * it with {@link AgentMessage.Ack} or {@link AgentMessage.Reject}, and a number that is not higher
 * than the last one has no further effect.
 */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonSubTypes({
  @Type(value = ServerMessage.Drive.class, name = "drive"),
  @Type(value = ServerMessage.Extend.class, name = "extend"),
  @Type(value = ServerMessage.Release.class, name = "release"),
  @Type(value = ServerMessage.Room.class, name = "room"),
  @Type(value = ServerMessage.Lead.class, name = "lead"),
  @Type(value = ServerMessage.Follow.class, name = "follow"),
  @Type(value = ServerMessage.Act.class, name = "act"),
  @Type(value = ServerMessage.AckActed.class, name = "ack_acted"),
  @Type(value = ServerMessage.Hold.class, name = "hold"),
  @Type(value = ServerMessage.Resume.class, name = "resume"),
  @Type(value = ServerMessage.Clear.class, name = "clear"),
  @Type(value = ServerMessage.Cancel.class, name = "cancel"),
  @Type(value = ServerMessage.Locate.class, name = "locate"),
  @Type(value = ServerMessage.Ping.class, name = "ping"),
  @Type(value = ServerMessage.AckDone.class, name = "ack"),
  @Type(value = ServerMessage.LeaderPose.class, name = "pose"),
  @Type(value = ServerMessage.FormationEnd.class, name = "formation_end"),
})
public sealed interface ServerMessage {

  /** A message that has a sequence number. */
  sealed interface Command extends ServerMessage {
    /** Higher than that of every earlier command to the robot. */
    long seq();
  }

  /**
   * Drive along segments. Legal only for a robot that is stopped.
   *
   * @param seq also the number by which later messages name this drive
   * @param task null for charging and going home, which have phase 0
   * @param phase 0 to 3
   * @param start where the robot is, map frame
   * @param released only the first so many segments may be driven yet; counted from the drive's
   *     first
   * @param last (on the wire {@code final}) the segments end the phase; false: an {@link Extend}
   *     brings the rest
   * @param load kilograms that the robot has on board
   */
  record Drive(
      long seq,
      @JsonSetter(nulls = Nulls.SET) @Nullable Long task,
      int phase,
      Pose start,
      List<Segment> segments,
      int released,
      @JsonProperty("final") boolean last,
      double load)
      implements Command {}

  /**
   * Replaces the segments with index {@code from} and above.
   *
   * @param drive the sequence number of the drive
   * @param from an index, 0 for the drive's first segment; not below what was released
   * @param released how many of the drive's segments may be driven then
   */
  record Extend(
      long seq,
      long drive,
      int from,
      List<Segment> segments,
      int released,
      @JsonProperty("final") boolean last)
      implements Command {}

  /**
   * Drive on, up to the end of what is released.
   *
   * @param drive the sequence number of the drive
   * @param released how many of the drive's segments may be driven, from its first; only grows
   */
  record Release(long seq, long drive, int released) implements Command {}

  /**
   * Room beside the path is the robot's own, to drive round what it sees there, until it says that
   * it has given it back; instead of room that it was lent before.
   *
   * @param drive the sequence number of the drive
   * @param from the first segment beside which it is, counted from the drive's first
   * @param to the first one beside which it is not any more; it is released
   * @param left metres that the robot's middle may be to the left of its path
   * @param right metres that it may be to the right
   * @param zone in which the robot finds its own way from where segment {@code from} begins to
   *     where segment {@code to} does; null: none. Only for robots that say that they can
   */
  record Room(
      long seq,
      long drive,
      int from,
      int to,
      double left,
      double right,
      @JsonSetter(nulls = Nulls.SET) @Nullable FreeZone zone)
      implements Command {

    /** Beside the path. */
    public Room(long seq, long drive, int from, int to, double left, double right) {
      this(seq, drive, from, to, left, right, null);
    }
  }

  /**
   * Lead these robots with the drive that comes next.
   *
   * @param tolerance metres that a follower may be off its place
   * @param carries its part of the load; null: nobody has said
   */
  record Lead(
      long seq,
      long task,
      double tolerance,
      List<Follower> followers,
      @JsonSetter(nulls = Nulls.SET) @Nullable CarriedPart carries)
      implements Command {}

  /**
   * What a robot has of a load that several carry.
   *
   * @param share kilograms that it is to bear
   * @param load kilograms of the whole load
   * @param point where it holds the load, metres, in the robot's frame
   * @param middle of the load as it is picked up, its centre of mass: metres, map frame
   */
  record CarriedPart(double share, double load, Vec2 point, Vec2 middle) {}

  /**
   * Where a leader connects to a follower.
   *
   * @param port of TCP, 1 to 65535
   * @param fingerprint of its certificate; null where the link is not encrypted
   */
  record Follower(
      String robot,
      String host,
      int port,
      @JsonSetter(nulls = Nulls.SET) @Nullable String fingerprint) {}

  /**
   * Keep a place beside a leader until its end of the formation.
   *
   * @param fingerprint of the leader's certificate; null where the link is not encrypted
   * @param offset metres, in the leader's frame: x forward, y left
   * @param tolerance metres that the robot may be off its place
   * @param carries its part of the load; null: nobody has said
   */
  record Follow(
      long seq,
      long task,
      String leader,
      @JsonSetter(nulls = Nulls.SET) @Nullable String fingerprint,
      Vec2 offset,
      double tolerance,
      @JsonSetter(nulls = Nulls.SET) @Nullable CarriedPart carries)
      implements Command {}

  /**
   * Do this with the arm. Legal only for a robot that is stopped and has ended the phase's drive.
   *
   * @param phase 1 to 3
   * @param target where the hand shall come, metres, in that frame
   * @param load kilograms that the load has, as was ordered
   */
  record Act(
      long seq, long task, int phase, ArmAction action, Frame frame, Vec2 target, double load)
      implements Command {}

  /** What coordinates count from. */
  enum Frame {
    MAP,
    /** From the robot's centre: x forward, y left. */
    ROBOT
  }

  /** Stop within the limits, and stay stopped until {@link Resume}. */
  record Hold(long seq) implements Command {}

  /** End the hold; clears no stop. */
  record Resume(long seq) implements Command {}

  /**
   * A person has looked at the robot, and says that what its hardware stopped it for is over. After
   * that it waits for a new drive.
   *
   * @param reasons the codes of all faults that are {@link AgentMessage.Fault#clearable}, as the
   *     person was shown them
   */
  record Clear(long seq, List<String> reasons) implements Command {
    public Clear {
      reasons = List.copyOf(reasons);
    }
  }

  /**
   * Stop, and forget task, phase and drive.
   *
   * @param task its id; null for a drive without a task
   */
  record Cancel(long seq, @JsonSetter(nulls = Nulls.SET) @Nullable Long task) implements Command {}

  /**
   * The operator or a parking dock says where the robot is.
   *
   * @param pose metres and radians, map frame
   */
  record Locate(long seq, Pose pose) implements Command {}

  /** Shows that the server is there. */
  record Ping(long seq) implements Command {}

  /**
   * The server has stored that the drive is done.
   *
   * @param done the sequence number of the drive
   */
  record AckDone(long done) implements ServerMessage {}

  /**
   * The server has stored how the act ended.
   *
   * @param acted the sequence number of the act
   */
  record AckActed(long acted) implements ServerMessage {}

  /** A message of a leading robot; each is answered with {@link AgentMessage.FollowerReport}. */
  sealed interface LeaderMessage extends ServerMessage {
    long task();
  }

  /**
   * Where the leader is: every 200 ms, and more often while it brakes.
   *
   * @param seq counted by the leader from 1
   * @param stamp the leader's own clock, milliseconds since 1970: information only
   * @param pose map frame
   */
  record LeaderPose(long task, long seq, long stamp, Pose pose, AgentMessage.Speed twist)
      implements LeaderMessage {}

  /**
   * The leader is at its goal.
   *
   * @param task its id
   */
  record FormationEnd(long task) implements LeaderMessage {}
}
