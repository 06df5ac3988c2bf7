package org.toqa.fleet.robot;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.NegotiationMessage;
import org.toqa.arm.ArmAction;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotRecord;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage.CarriedPart;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.mission.Phase;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.wording.Sentence;

/** What a robot agent is told: by its floor, by its link, by its store, by the clock. */
public sealed interface RobotMessage {

  /**
   * Drive this trajectory.
   *
   * @param released so many segments of it for now
   * @param last whether it ends the phase
   * @param load kilograms that it has on board
   * @param lead whom it leads with that, and does not begin without; null: nobody
   */
  record Drive(
      @Nullable Long task,
      Phase phase,
      Trajectory trajectory,
      int released,
      boolean last,
      double load,
      @Nullable Lead lead)
      implements RobotMessage {}

  /**
   * Lead these robots.
   *
   * @param carries its part of the load; null: not known
   */
  record Lead(
      long task, double tolerance, List<Follower> followers, @Nullable CarriedPart carries) {}

  /** Drive other segments from {@code from} on. */
  record Extend(int from, List<Segment> segments, int released, boolean last)
      implements RobotMessage {}

  /**
   * Keep a place beside a leader.
   *
   * @param fingerprint of the leader's certificate; null: it was never paired
   * @param offset in the leader's frame, metres
   * @param tolerance metres
   * @param carries its part of the load; null: not known
   * @param pose where the robot is now, map frame
   */
  record Follow(
      long task,
      String leader,
      @Nullable String fingerprint,
      Vec2 offset,
      double tolerance,
      @Nullable CarriedPart carries,
      Pose pose)
      implements RobotMessage {}

  record Release(int released) implements RobotMessage {}

  /** There is room beside its path. */
  record LendRoom(PassingRoom room) implements RobotMessage {}

  /** The robot has given back what it was lent. */
  record RoomReturned() implements RobotMessage {}

  record Cancel(@Nullable Long task) implements RobotMessage {}

  /**
   * Do this with the arm.
   *
   * @param target where the hand shall come, metres, map frame
   * @param load kilograms, as was ordered
   */
  record Act(long task, Phase phase, ArmAction action, Vec2 target, double load)
      implements RobotMessage {}

  /** What followed from the end of this act is stored. */
  record AcknowledgeAct(long act) implements RobotMessage {}

  /** Hold, or go on. */
  record Hold(boolean hold) implements RobotMessage {}

  /**
   * A person has cleared these stops. Sent at once or never.
   *
   * @param reasons codes of clearable faults
   */
  record Clear(Set<String> reasons) implements RobotMessage {}

  /**
   * What sensors beside the link see now.
   *
   * @param ranges metres from the robot's rim, with the angles of {@code angles}
   * @param angles radians, counter-clockwise from straight ahead; as many
   */
  record RangesHeard(List<Double> ranges, List<Double> angles) implements RobotMessage {
    public RangesHeard {
      ranges = List.copyOf(ranges);
      angles = List.copyOf(angles);
    }
  }

  record Locate(Pose pose) implements RobotMessage {}

  /** A floor announces tasks, or proposes a contract. */
  record Negotiate(NegotiationMessage message, ActorRef<NegotiationMessage.Reply> replyTo)
      implements RobotMessage {}

  /** A person has entered something else of the robot; its address is the same. */
  record RecordChanged(RobotRecord robot) implements RobotMessage {}

  /** What followed from the end of this drive is stored. */
  record Acknowledge(long drive) implements RobotMessage {}

  /** There is something in the inbox of this link. */
  record InboxFilled(LinkInbox inbox) implements RobotMessage {}

  record LinkOpened(Hello hello) implements RobotMessage {}

  record MessageReceived(AgentMessage message) implements RobotMessage {}

  record LinkClosed(Sentence why) implements RobotMessage {}

  /** The link is down, for one end does not trust the other. */
  record LinkRefused(Sentence why) implements RobotMessage {}

  /** The robot has another certificate, and perhaps another address. */
  record Reconnect(RobotRecord robot) implements RobotMessage {}

  record DriveLoaded(Optional<StoredDrive> drive) implements RobotMessage {}

  /** What a command that waits is about is safe: it may be sent. */
  record CommandStored(long id) implements RobotMessage {}

  /**
   * What had to be stored before a command was sent can never be.
   *
   * @param id of the command that waits
   * @param changing the drive that the command was to change, if it was such a one
   */
  record CommandNotStored(long id, @Nullable Long changing, String reason)
      implements RobotMessage {}

  /**
   * @param now is asked once, when the tick is taken
   */
  record Tick(Supplier<Instant> now) implements RobotMessage {}

  record Stop() implements RobotMessage {}
}
