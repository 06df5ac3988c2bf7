package org.toqa.agent.control;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.Avoidance;
import org.toqa.agent.drive.DriveRules;
import org.toqa.agent.formation.FormationRules;
import org.toqa.agent.storage.JournalEntry;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.Segment;

/**
 * What a robot refuses for what it does now. Each rule answers with the sentence that goes back to
 * the server, or with nothing.
 */
final class CommandRules {

  /** Metres from the map's origin. */
  private static final double FARTHEST = 150_000;

  private final DriveRules driveRules;
  private final FormationRules formationRules;
  private final RobotRecord record;
  private final Avoidance avoidance;
  private final boolean canShift;

  /**
   * @param encrypted whether the link is
   * @param record of the robot
   */
  CommandRules(AgentConfig config, boolean encrypted, RobotRecord record) {
    this.driveRules = new DriveRules(config.limits(), config.footprint() / 2);
    this.formationRules = new FormationRules(config, encrypted);
    this.record = record;
    this.avoidance = config.avoidance();
    this.canShift = config.canShift();
  }

  /** The drive that a command names. */
  sealed interface NamedDrive {
    record Found(DriveRun run) implements NamedDrive {}

    /** It does not drive. */
    record NotFound(String sentence) implements NamedDrive {}
  }

  /**
   * @param drive the sequence number of the drive
   */
  NamedDrive find(long drive, Activity activity) {
    long own = record.entry().drive();
    return activity
        .drive()
        .filter(_ -> own == drive)
        .<NamedDrive>map(NamedDrive.Found::new)
        .orElseGet(
            () ->
                new NamedDrive.NotFound(
                    own == 0
                        ? "There is no drive %d any more; the robot has none.".formatted(drive)
                        : "There is no drive %d any more; the robot has drive %d."
                            .formatted(drive, own)));
  }

  Optional<String> objectionTo(Drive drive, Activity activity, @Nullable ArmWork arm) {
    return objectionToDriving(activity)
        .or(() -> objectionOfArm(arm))
        .or(() -> objectionAsLeader(drive, activity))
        .or(() -> objectionToShift(drive.segments(), activity))
        .or(() -> driveRules.objectionTo(drive, record.pose()));
  }

  /** An arm does one thing, for the task that the robot works for, if it does. */
  Optional<String> objectionTo(Act act, Activity activity, @Nullable ArmWork arm) {
    if (arm == null) {
      return Optional.of("The robot has no arm.");
    }
    JournalEntry entry = record.entry();
    Long task = entry.task();
    if (task != null && task != act.task()) {
      return Optional.of(
          "The robot works for task %d, not for task %d.".formatted(task, act.task()));
    }
    if (act.phase() < 1 || act.phase() > 3) {
      return Optional.of("The phase is %d; an act has phase 1 to 3.".formatted(act.phase()));
    }
    if (!(act.target().norm() <= FARTHEST) || !(act.load() >= 0)) {
      return Optional.of(
          "The target must be within 100 km, and the load must not be less than 0 kg.");
    }
    return objectionToDriving(activity).or(() -> objectionOfArm(arm));
  }

  private static Optional<String> objectionOfArm(@Nullable ArmWork arm) {
    return arm == null
        ? Optional.empty()
        : arm.order()
            .map(
                act ->
                    "The arm has not ended act %d; wait for its end or send cancel."
                        .formatted(act.seq()));
  }

  Optional<String> objectionTo(Extend extend, DriveRun run, Activity activity) {
    return objectionToShift(extend.segments(), activity)
        .or(() -> driveRules.objectionTo(extend, run.trajectory()));
  }

  Optional<String> objectionTo(Release release, DriveRun run) {
    return driveRules.objectionTo(release, run.trajectory());
  }

  Optional<String> objectionTo(Room room, DriveRun run, Activity activity) {
    if (room.zone() != null) {
      return activity instanceof Alone && avoidance == Avoidance.FOUR_AGENTS
          ? driveRules.objectionTo(room, run.trajectory())
          : Optional.of(
              "Only a robot that drives alone, with four agents, finds its way through a free zone.");
    }
    if (!(activity instanceof Alone)) {
      return Optional.of("Only a robot that drives alone needs room.");
    }
    return driveRules.objectionTo(room, run.trajectory());
  }

  Optional<String> objectionTo(Lead lead, Activity activity, @Nullable ArmWork arm) {
    return objectionToDriving(activity)
        .or(() -> objectionOfArm(arm))
        .or(() -> formationRules.objectionTo(lead));
  }

  Optional<String> objectionTo(Follow follow, Activity activity, @Nullable ArmWork arm) {
    return objectionToDriving(activity)
        .or(() -> objectionOfArm(arm))
        .or(() -> formationRules.objectionTo(follow));
  }

  Optional<String> objectionTo(Locate locate, Activity activity) {
    boolean canBeMoved =
        activity.drive().isEmpty()
            && !(activity instanceof Following)
            && record.reading().isStanding();
    return canBeMoved
        ? driveRules.objectionTo(locate)
        : Optional.of("A robot that drives cannot be told where it is; send cancel first.");
  }

  /** What stops the robot must be what the person was shown, no more and no less. */
  Optional<String> objectionTo(Clear clear) {
    Set<String> stops = record.reading().stops();
    if (stops.isEmpty()) {
      return Optional.of("Nothing stops the robot that a person could clear.");
    }
    return stops.equals(Set.copyOf(clear.reasons()))
        ? Optional.empty()
        : Optional.of(
            "What stops the robot has changed; it is %s now."
                .formatted(stops.stream().sorted().collect(Collectors.joining(", "))));
  }

  private Optional<String> objectionToDriving(Activity activity) {
    if (!record.reading().faults().isEmpty()) {
      return Optional.of("The robot cannot drive: " + record.reading().faults().getFirst().text());
    }
    if (!record.isLocalised()) {
      return Optional.of("The robot does not know where it is; send locate first.");
    }
    if (activity instanceof Following(var follower)) {
      return Optional.of(
          "The robot follows %s; wait for the formation's end or send cancel."
              .formatted(follower.order().leader()));
    }
    if (activity.drive().filter(run -> !run.isCancelled()).isPresent()) {
      return Optional.of(
          "The robot has not ended drive %d; wait for its end or send cancel."
              .formatted(record.entry().drive()));
    }
    return activity.drive().isEmpty() && record.reading().isStanding()
        ? Optional.empty()
        : Optional.of("The robot is still moving; wait until it has stopped.");
  }

  /** The body of a robot alone drives by itself, and knows of no shift. */
  private Optional<String> objectionToShift(List<Segment> segments, Activity activity) {
    return segments.stream().anyMatch(Segment::shifts) && !(canShift && activity instanceof Leading)
        ? Optional.of(
            "Only a leader that can go sideways shifts its group; send segments without u.")
        : Optional.empty();
  }

  private static Optional<String> objectionAsLeader(Drive drive, Activity activity) {
    return activity instanceof Leading(var leader, _)
            && !(drive.phase() == 2 && Objects.equals(drive.task(), leader.order().task()))
        ? Optional.of(
            "The robot leads phase 2 of task %d; send cancel first."
                .formatted(leader.order().task()))
        : Optional.empty();
  }
}
