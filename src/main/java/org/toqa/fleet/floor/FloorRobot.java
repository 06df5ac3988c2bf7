package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.motion.DriveSpeeds;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What a floor agent knows of one of its robots. Confined to that agent.
 *
 * <p>What the robot says ({@code pose}, {@code mode}, {@code drive}, ...) and what the floor wants
 * of it ({@code errand}, {@code way}) stand side by side; the floor acts where they differ.
 */
final class FloorRobot {
  private static final Logger log = LoggerFactory.getLogger(FloorRobot.class);

  /** The diameter assumed of a robot that was never heard of: the smallest of ours, metres. */
  static final double UNKNOWN_FOOTPRINT = 0.255;

  /** Metres and radians a second that a standing robot may still report. */
  private static final double STANDING_SPEED = 0.02;

  private static final double STANDING_TURN = 0.05;

  RobotRecord record;
  final ActorRef<RobotMessage> agent;

  // what the robot says
  boolean connected;
  boolean silent;

  /** Since when it is not heard; means nothing while it is. */
  Instant silentSince;

  boolean localised;
  @Nullable Pose pose;
  @Nullable Double battery;
  double footprint = UNKNOWN_FOOTPRINT;
  DriveSpeeds speeds = DriveSpeeds.DEFAULT;
  double maxLoad;

  /** What it says that it carries. */
  private double reportedMaxLoad = Double.MAX_VALUE;

  Mode mode = Mode.IDLE;
  Role role = Role.ALONE;
  boolean moving;
  long drive;
  int segment;
  @Nullable Long reportedTask;
  List<Fault> errors = List.of();
  @Nullable Instant lastSeen;

  /** Why it and the server do not trust each other; null: they do, or never met. */
  @Nullable Sentence alert;

  /** When the history was last told whom it did not let in. */
  Instant strangerNotedAt = Instant.MIN;

  // what a person has said
  boolean inService = true;
  boolean held;

  // what the floor wants of it
  @Nullable DriveGoal driveGoal;

  /** The drive that it was told, until it is over. */
  @Nullable StoredDrive toldDrive;

  /** Where that drive shall lead; null where it only steps aside, or after a restart. */
  @Nullable Vec2 toldGoal;

  /** A drive was told and the robot has not said yet that it takes it. */
  boolean drivePending;

  boolean cancelling;

  /** A change of its drive that it refused, until its state tells whether it still drives that. */
  RobotEvent.@Nullable CommandRejected rejectedChange;

  /** How long it has worked since it last charged. */
  Duration workedSinceCharge = Duration.ZERO;

  /** The same, as it is stored. */
  Duration storedWork = Duration.ZERO;

  /** Its place at a charging point; null: it need not charge. */
  @Nullable Turn turn;

  /** Whether that is safe, so that it may move for it. */
  boolean turnStored;

  /** Whether it stands at the charging point and is the first one there. */
  boolean charging;

  /** What it does about charging. */
  @Nullable Sentence chargingStatus;

  /** A task that it was free for, but its battery would not have lasted. */
  @Nullable Long taskBeyondBattery;

  /** Why it shall hold; null: it need not. */
  @Nullable Sentence holdReason;

  /** Whether it was told to hold, on this connection. */
  boolean toldToHold;

  Instant toldToHoldAt = Instant.MIN;

  /** When it last was to hold. */
  Instant lastHeld = Instant.MIN;

  /** Since when it stands before an obstacle on its way; null: it does not. */
  @Nullable Instant obstructedSince;

  /** Since when it stands and has nothing to do. */
  @Nullable Instant idleSince;

  Instant notBefore = Instant.MIN;
  @Nullable Sentence waitReason;

  /**
   * A phase that the robot shall drive.
   *
   * @param task null when it drives home or to a charger, in phase 0
   * @param heading how it shall face there, radians, map frame; null: in any way
   * @param load kilograms that it has on board
   */
  record DriveGoal(
      @Nullable Long task, int phase, Vec2 goal, @Nullable Double heading, double load) {
    static DriveGoal toParking(Vec2 parking) {
      return new DriveGoal(null, 0, parking, null, 0);
    }

    static DriveGoal toCharger(Vec2 point) {
      return new DriveGoal(null, 0, point, null, 0);
    }

    /**
     * What the robot's phase of the mission asks.
     *
     * @param home its parking point
     */
    static DriveGoal of(Mission mission, String robot, Optional<Vec2> home) {
      int phase = mission.assignedRobot(robot).map(AssignedRobot::phase).orElse(3);
      Vec2 goal =
          switch (phase) {
            case 1 -> mission.object().position();
            case 2 -> mission.destination().position();
            default -> home.orElse(mission.task().goal().position());
          };
      double load = phase == 2 ? mission.task().load() / mission.assignedRobots().size() : 0;
      return new DriveGoal(mission.id(), phase, goal, null, load);
    }
  }

  FloorRobot(RobotRecord record, ActorRef<RobotMessage> agent, Instant now) {
    this.silentSince = now;
    this.record = record;
    this.agent = agent;
    this.maxLoad = record.maxLoad();
  }

  void setRecord(RobotRecord changed) {
    record = changed;
    maxLoad = Math.min(record.maxLoad(), reportedMaxLoad);
  }

  String name() {
    return record.name();
  }

  void update(Hello hello, Instant now) {
    connected = true;
    silent = false;
    localised = hello.localised();
    pose = hello.pose();
    footprint = hello.footprint();
    speeds = DriveSpeeds.DEFAULT.atMost(hello.maxSpeed());
    reportedMaxLoad = hello.maxLoad();
    maxLoad = Math.min(record.maxLoad(), reportedMaxLoad);
    mode = hello.mode();
    role = hello.role();
    drive = hello.drive();
    reportedTask = hello.task();
    segment = hello.segment();
    lastSeen = now;
  }

  void update(AgentMessage.State state, Instant now) {
    silent = false;
    localised = state.localised();
    pose = state.pose();
    battery = state.battery();
    mode = state.mode();
    role = state.role();
    drive = state.drive();
    reportedTask = state.task();
    segment = state.segment();
    moving =
        Math.abs(state.twist().v()) > STANDING_SPEED || Math.abs(state.twist().w()) > STANDING_TURN;
    errors = state.errors();
    lastSeen = now;
  }

  Optional<Turn> turn() {
    return Optional.ofNullable(turn);
  }

  boolean isHeard() {
    return connected && !silent;
  }

  /** In service, hears, knows where it is, and is well. */
  boolean isFit() {
    return inService && isHeard() && localised && mode != Mode.ERROR;
  }

  /** What it shall drive now, if it is in service. */
  @Nullable DriveGoal activeGoal() {
    return inService ? driveGoal : null;
  }

  boolean isStanding() {
    boolean stands = mode == Mode.IDLE || (mode == Mode.HOLDING && !moving);
    return stands && drive == 0 && !drivePending;
  }

  /** Whether it has ended or given up its drive and stands, well or not. */
  boolean hasStopped() {
    return isHeard() && !moving && mode != Mode.DRIVING && drive == 0 && !drivePending;
  }

  /** Whether it drives, or was just told to drive, what this errand asks. */
  boolean isDrivingTo(DriveGoal wanted) {
    return toldDrive != null
        && (drivePending || drive == toldDrive.seq())
        && toldDrive.phase() == wanted.phase()
        && Objects.equals(wanted.task(), toldDrive.task())
        && (toldGoal == null || toldGoal.equals(wanted.goal()));
  }

  /** Ends its drive, once. */
  void cancelDrive() {
    if (connected && !cancelling) {
      cancelling = true;
      log.info("{}: its drive {} is not wanted any more.", name(), drive);
      agent.tell(new RobotMessage.Cancel(reportedTask));
    }
  }

  RobotState state() {
    if (!inService) {
      return RobotState.OUT_OF_SERVICE;
    }
    if (lastSeen == null) {
      return RobotState.CONNECTING;
    }
    if (!isHeard()) {
      return RobotState.LOST;
    }
    if (!localised) {
      return RobotState.NOT_LOCALISED;
    }
    return switch (mode) {
      case IDLE -> charging ? RobotState.CHARGING : RobotState.IDLE;
      case DRIVING, FOLLOWING -> RobotState.DRIVING;
      case HOLDING -> RobotState.HOLDING;
      case ERROR -> RobotState.ERROR;
    };
  }

  /**
   * @param work its part in the mission that it belongs to
   */
  RobotView view(String floor, @Nullable DriveGoal work, RemainingPath path) {
    return new RobotView(
        name(),
        floor,
        state(),
        pose,
        battery,
        work == null ? null : work.task(),
        work == null ? 0 : work.phase(),
        maxLoad,
        footprint,
        speeds.forward(),
        record.host(),
        record.port(),
        record.parking(),
        record.simulated(),
        path.points(),
        path.released(),
        errors,
        activity(work),
        lastSeen,
        holdReason != null,
        turn == null ? null : turn.point(),
        record.fingerprint(),
        alert);
  }

  private Sentence activity(@Nullable DriveGoal work) {
    return switch (state()) {
      case CONNECTING ->
          alert == null ? Phrase.TRYING_TO_REACH.with(record.host(), record.port()) : alert;
      case LOST ->
          Phrase.LOST.with(
              alert == null ? Phrase.NOTHING_HEARD.with() : alert,
              (pose == null ? Phrase.NOBODY_KNOWS_WHERE : Phrase.PLACE_STAYS_RESERVED).with());
      case NOT_LOCALISED -> Phrase.MUST_BE_LOCALISED.with();
      case ERROR ->
          errors.isEmpty()
              ? Phrase.HAS_ERROR.with()
              : Phrase.HAS_FAULT.with(errors.getFirst().text());
      case OUT_OF_SERVICE -> Phrase.STAYS_OUT_OF_SERVICE.with(outOfServicePhrase().with());
      case IDLE, DRIVING, HOLDING, CHARGING -> {
        if (holdReason != null) {
          yield holdReason;
        }
        if (chargingStatus != null && (work == null || work.task() == null)) {
          yield waitReason == null ? chargingStatus : waitReason;
        }
        yield work == null ? Phrase.IS_FREE.with() : workSentence(work);
      }
    };
  }

  private Phrase outOfServicePhrase() {
    if (isHeard()) {
      return Phrase.STAYS_WITHOUT_TASK;
    }
    return pose == null ? Phrase.PLACE_IS_FREE : Phrase.PLACE_STAYS_UNTIL_SAID;
  }

  /** Of its certificate, 64 digits; null: it was never paired. */
  @Nullable String fingerprint() {
    Fingerprint known = record.fingerprint();
    return known == null ? null : known.hex();
  }

  /** Why its group stands, as the robot says; null where it does not. */
  @Nullable String groupStopReason() {
    return role == Role.ALONE || errors.isEmpty() ? null : errors.getFirst().text();
  }

  private Sentence workSentence(DriveGoal work) {
    if (waitReason != null) {
      return waitReason;
    }
    String reason = groupStopReason();
    if (reason != null) {
      return Sentence.verbatim(reason);
    }
    Long task = work.task();
    if (task == null || work.phase() == 0) {
      return Phrase.DRIVES_HOME.with();
    }
    return switch (work.phase()) {
      case 1 -> Phrase.DRIVES_TO_LOAD.with(task);
      case 2 -> Phrase.CARRIES_LOAD.with(task);
      default -> Phrase.DRIVES_HOME_FROM.with(task);
    };
  }
}
