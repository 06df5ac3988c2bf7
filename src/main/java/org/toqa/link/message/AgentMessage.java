package org.toqa.link.message;

import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonSubTypes.Type;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.Nulls;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmAction;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.DriveKind;
import org.toqa.motion.PassingRoom;

/** What a robot says to the server, and a follower to its leader. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "type")
@JsonSubTypes({
  @Type(value = AgentMessage.Hello.class, name = "hello"),
  @Type(value = AgentMessage.State.class, name = "state"),
  @Type(value = AgentMessage.Done.class, name = "done"),
  @Type(value = AgentMessage.Acted.class, name = "acted"),
  @Type(value = AgentMessage.Ack.class, name = "ack"),
  @Type(value = AgentMessage.Reject.class, name = "reject"),
  @Type(value = AgentMessage.FollowerReport.class, name = "keep"),
})
public sealed interface AgentMessage {

  /** The version of the robot link that this product speaks. */
  int VERSION = 1;

  enum Mode {
    IDLE,
    DRIVING,
    HOLDING,
    FOLLOWING,
    ERROR
  }

  enum Role {
    ALONE,
    LEADER,
    FOLLOWER
  }

  /** Whether a robot has room beside its path, or needs it to get on. */
  enum RoomUse {
    NONE,
    WANTED,
    HELD
  }

  /**
   * The first line of a connection: with it a restarted server knows what the robot did meanwhile.
   *
   * @param maxLoad kilograms
   * @param maxSpeed metres a second
   * @param maxTurnRate radians a second
   * @param footprint diameter in metres
   * @param sensorRange metres that its range sensors see from its rim; 0: it has none
   * @param kind how it can move: the word of a {@link DriveKind}
   * @param track metres between its two wheels; 0: it has others, or does not tell
   * @param localised whether the robot trusts its pose; if not, it drives nothing until {@code
   *     locate}
   * @param pose map frame
   * @param drive sequence number of the present drive, 0 for none
   * @param segment how many segments of the drive are completed
   * @param released how many segments of the drive may be driven
   * @param lastSeq the highest sequence number accepted so far
   * @param done the last phase that was driven to its end and is not acknowledged yet
   * @param arm null: it has none
   * @param act sequence number of what the arm does now; null: nothing
   * @param acted how the last act ended that is not acknowledged yet
   * @param room that it was lent beside the path of its drive; null: none
   * @param freeZones whether it finds its own way through a free zone that it is lent
   * @param shifts whether it drives segments that go sideways, and follows a leader that does
   */
  record Hello(
      int version,
      String robot,
      double maxLoad,
      double maxSpeed,
      double maxTurnRate,
      double footprint,
      double sensorRange,
      String kind,
      double track,
      boolean localised,
      Pose pose,
      Mode mode,
      @JsonSetter(nulls = Nulls.SET) @Nullable Long task,
      int phase,
      Role role,
      long drive,
      int segment,
      int released,
      long lastSeq,
      @JsonSetter(nulls = Nulls.SET) @Nullable PhaseEnd done,
      @JsonSetter(nulls = Nulls.SET) @Nullable Arm arm,
      @JsonSetter(nulls = Nulls.SET) @Nullable Long act,
      @JsonSetter(nulls = Nulls.SET) @Nullable ActEnd acted,
      @JsonSetter(nulls = Nulls.SET) @Nullable PassingRoom room,
      boolean freeZones,
      boolean shifts)
      implements AgentMessage {

    /** That of a robot that follows its path through free zones too, and does not go sideways. */
    public Hello(
        int version,
        String robot,
        double maxLoad,
        double maxSpeed,
        double maxTurnRate,
        double footprint,
        double sensorRange,
        String kind,
        double track,
        boolean localised,
        Pose pose,
        Mode mode,
        @Nullable Long task,
        int phase,
        Role role,
        long drive,
        int segment,
        int released,
        long lastSeq,
        @Nullable PhaseEnd done,
        @Nullable Arm arm,
        @Nullable Long act,
        @Nullable ActEnd acted,
        @Nullable PassingRoom room) {
      this(
          version,
          robot,
          maxLoad,
          maxSpeed,
          maxTurnRate,
          footprint,
          sensorRange,
          kind,
          track,
          localised,
          pose,
          mode,
          task,
          phase,
          role,
          drive,
          segment,
          released,
          lastSeq,
          done,
          arm,
          act,
          acted,
          room,
          false,
          false);
    }

    /** That of a robot without an arm, and without room beside its path. */
    public Hello(
        int version,
        String robot,
        double maxLoad,
        double maxSpeed,
        double maxTurnRate,
        double footprint,
        double sensorRange,
        String kind,
        double track,
        boolean localised,
        Pose pose,
        Mode mode,
        @Nullable Long task,
        int phase,
        Role role,
        long drive,
        int segment,
        int released,
        long lastSeq,
        @Nullable PhaseEnd done) {
      this(
          version,
          robot,
          maxLoad,
          maxSpeed,
          maxTurnRate,
          footprint,
          sensorRange,
          kind,
          track,
          localised,
          pose,
          mode,
          task,
          phase,
          role,
          drive,
          segment,
          released,
          lastSeq,
          done,
          null,
          null,
          null,
          null);
    }

    public DriveKind driveKind() {
      return DriveKind.of(kind);
    }
  }

  /**
   * A phase flag: this drive ended this phase of this task.
   *
   * @param task its id; null for a drive without a task
   * @param phase 0 to 3
   * @param drive the sequence number of the drive's command
   */
  record PhaseEnd(@JsonSetter(nulls = Nulls.SET) @Nullable Long task, int phase, long drive) {}

  /**
   * How what an arm was told ended.
   *
   * @param act the sequence number of the command
   * @param failure null: it is done
   * @param weight kilograms of what it picked up; null: it has weighed nothing
   */
  record ActEnd(
      long act,
      long task,
      int phase,
      ArmAction action,
      @JsonSetter(nulls = Nulls.SET) @Nullable ActFailure failure,
      @JsonSetter(nulls = Nulls.SET) @Nullable Double weight) {}

  /**
   * @param code the name of an {@link org.toqa.arm.ArmFailure}, or what a robot of another make
   *     says
   * @param text a sentence for people
   */
  record ActFailure(String code, String text) {}

  /**
   * An arm as it is.
   *
   * @param joints radians
   * @param load kilograms in its hand; null: nothing
   * @param act sequence number of what it does; null: nothing
   * @param step of that; null: none
   */
  record ArmState(
      JointAngles joints,
      @JsonSetter(nulls = Nulls.SET) @Nullable Double load,
      @JsonSetter(nulls = Nulls.SET) @Nullable Long act,
      @JsonSetter(nulls = Nulls.SET) @Nullable ArmStep step) {}

  /**
   * Five times a second and on change.
   *
   * @param stamp the robot's own clock, milliseconds since 1970: information only
   * @param battery 0 to 1
   * @param ranges metres, in the order of the robot's range sensors
   * @param placeError metres off its place beside its leader; null: it does not follow
   * @param measuredLoad kilograms that it bears, as its body measures; null: it has nothing on
   *     board, or no scale
   * @param arm null: it has none
   * @param room whether it has room beside its path, or needs it
   * @param camera what it sees now; null: it has none, or sees nothing at all
   * @param networkRoute by which the server is reached in an ad hoc network; null: the robot is in
   *     none, or knows no route
   */
  record State(
      long stamp,
      boolean localised,
      Pose pose,
      Speed twist,
      Mode mode,
      @JsonSetter(nulls = Nulls.SET) @Nullable Long task,
      int phase,
      Role role,
      long drive,
      int segment,
      int released,
      double battery,
      List<Double> ranges,
      List<Vec2> obstacles,
      @JsonSetter(nulls = Nulls.SET) @Nullable Double placeError,
      @JsonSetter(nulls = Nulls.SET) @Nullable Double measuredLoad,
      @JsonSetter(nulls = Nulls.SET) @Nullable ArmState arm,
      RoomUse room,
      @JsonSetter(nulls = Nulls.SET) @Nullable CameraView camera,
      @JsonSetter(nulls = Nulls.SET) @Nullable NetworkRoute networkRoute,
      List<Fault> errors)
      implements AgentMessage {

    /** That of a robot without cameras, which is in no ad hoc network. */
    public State(
        long stamp,
        boolean localised,
        Pose pose,
        Speed twist,
        Mode mode,
        @Nullable Long task,
        int phase,
        Role role,
        long drive,
        int segment,
        int released,
        double battery,
        List<Double> ranges,
        List<Vec2> obstacles,
        @Nullable Double placeError,
        @Nullable Double measuredLoad,
        @Nullable ArmState arm,
        RoomUse room,
        List<Fault> errors) {
      this(
          stamp,
          localised,
          pose,
          twist,
          mode,
          task,
          phase,
          role,
          drive,
          segment,
          released,
          battery,
          ranges,
          obstacles,
          placeError,
          measuredLoad,
          arm,
          room,
          null,
          null,
          errors);
    }

    /** That of a robot without an arm, which needs no room beside its path. */
    public State(
        long stamp,
        boolean localised,
        Pose pose,
        Speed twist,
        Mode mode,
        @Nullable Long task,
        int phase,
        Role role,
        long drive,
        int segment,
        int released,
        double battery,
        List<Double> ranges,
        List<Vec2> obstacles,
        @Nullable Double placeError,
        @Nullable Double measuredLoad,
        List<Fault> errors) {
      this(
          stamp,
          localised,
          pose,
          twist,
          mode,
          task,
          phase,
          role,
          drive,
          segment,
          released,
          battery,
          ranges,
          obstacles,
          placeError,
          measuredLoad,
          null,
          RoomUse.NONE,
          null,
          null,
          errors);
    }

    /** The same, as if it had seen these obstacles only. */
    public State withObstacles(List<Vec2> seen) {
      return new State(
          stamp,
          localised,
          pose,
          twist,
          mode,
          task,
          phase,
          role,
          drive,
          segment,
          released,
          battery,
          ranges,
          seen,
          placeError,
          measuredLoad,
          arm,
          room,
          camera,
          networkRoute,
          errors);
    }
  }

  /**
   * The route of a robot to its server in an ad hoc network.
   *
   * @param nextHop the address of whom it sends to first
   * @param metric of the whole route, as babeld counts it: 256 for each transmission that is
   *     expected (ETX), so 256 a hop where nothing is lost
   * @param quality 0 to 1, of the last 16 greetings of the next hop how many were heard
   */
  record NetworkRoute(String nextHop, int metric, double quality) {}

  /**
   * What cameras that look all round see.
   *
   * @param range metres: no farther, and not behind walls
   * @param boxes those that lie in view
   */
  record CameraView(double range, List<SeenBox> boxes) {
    public CameraView {
      boxes = List.copyOf(boxes);
    }
  }

  /**
   * A box that a camera knows by the number on it.
   *
   * @param place metres, map frame
   */
  record SeenBox(int box, Vec2 place) {}

  /**
   * @param v metres a second, forward
   * @param w radians a second, counter-clockwise
   */
  record Speed(double v, double w, double u) {

    /** Of a robot that does not go sideways. */
    public Speed(double v, double w) {
      this(v, w, 0);
    }

    public static Speed of(Twist twist) {
      return new Speed(twist.vx(), twist.w(), twist.vy());
    }

    public Twist twist() {
      return new Twist(v, u, w);
    }
  }

  /**
   * @param code a word for programs
   * @param text a sentence for people
   * @param clearable whether the robot's hardware has stopped it, until a person's word ({@link
   *     ServerMessage.Clear})
   */
  record Fault(String code, String text, boolean clearable) {

    /** One that goes by itself when its cause has gone. */
    public Fault(String code, String text) {
      this(code, text, false);
    }
  }

  /**
   * Sent again until the server has acknowledged it.
   *
   * @param task its id; null for a drive without a task
   * @param phase 0 to 3
   * @param drive the sequence number of the drive's command
   */
  record Done(@JsonSetter(nulls = Nulls.SET) @Nullable Long task, int phase, long drive)
      implements AgentMessage {}

  /**
   * What the arm was told has ended. Sent again until the server has acknowledged it.
   *
   * @param act the sequence number of the command
   * @param failure null: it is done
   * @param weight kilograms of what it picked up; null: it has weighed nothing
   */
  record Acted(
      long act,
      long task,
      int phase,
      ArmAction action,
      @JsonSetter(nulls = Nulls.SET) @Nullable ActFailure failure,
      @JsonSetter(nulls = Nulls.SET) @Nullable Double weight)
      implements AgentMessage {

    public static Acted of(ActEnd end) {
      return new Acted(
          end.act(), end.task(), end.phase(), end.action(), end.failure(), end.weight());
    }

    public ActEnd end() {
      return new ActEnd(act, task, phase, action, failure, weight);
    }
  }

  /**
   * The command was accepted.
   *
   * @param seq the command's sequence number
   */
  record Ack(long seq) implements AgentMessage {}

  /**
   * The command was refused.
   *
   * @param seq the refused command's sequence number; 0 where the line had none
   * @param reason a sentence for people
   */
  record Reject(long seq, String reason) implements AgentMessage {}

  /**
   * A follower's answer to its leader.
   *
   * @param seq of the leader's pose; 0 in the answer to the end of the formation
   * @param pose map frame
   * @param error metres off its place
   * @param mode {@code FOLLOWING} if it can keep its place
   */
  record FollowerReport(long task, long seq, Pose pose, double error, Mode mode)
      implements AgentMessage {}
}
