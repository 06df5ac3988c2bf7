package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.Objects;
import java.util.Set;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.RobotCondition;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.Phase;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What a floor agent knows of one of its robots, in parts of which each is changed by the one whose
 * business it is. Confined to that agent.
 */
final class FloorRobot {
  private static final Logger log = LoggerFactory.getLogger(FloorRobot.class);

  /** The codes by which a robot reports that it stands, and will go on by itself. */
  private static final Set<String> STOPS_ON_PATH =
      Set.of(LastReport.OBSTACLE, LastReport.OFF_WAY, LastReport.ZONE_STUCK);

  final ActorRef<RobotMessage> agent;

  /** What the robot says. */
  final ReportedState reported;

  /** What people said of it. */
  final OperatorSettings settings;

  /** Where it shall drive, and what it was told. */
  final RobotDrive drive = new RobotDrive();

  final ChargingState charging = new ChargingState();
  final HoldState hold = new HoldState();

  /** Who drives it by hand. */
  final ManualControl manual = new ManualControl();

  final Obedience obedience = new Obedience();

  /** What its arm was told. */
  final ArmWork arm = new ArmWork();

  /** Where its task waits at a stop. */
  final StopWait stopWait = new StopWait();

  /** That it is stopped and has nothing to do. */
  final ConditionTimer idle = new ConditionTimer();

  /** That an obstacle on its path stops it. */
  final ConditionTimer obstructed = new ConditionTimer();

  /** That it stands because it is too far beside its path. */
  final ConditionTimer offPath = new ConditionTimer();

  /** That it follows, or would, though its leader has ended. */
  final ConditionTimer leftBehind = new ConditionTimer();

  /** That it stands as a leader for followers that follow. */
  final ConditionTimer separated = new ConditionTimer();

  /** When it was told last where it is. */
  Instant locatedAt = Instant.MIN;

  /** While it leads a group, not all of which follow it. */
  final ConditionTimer unfollowed = new ConditionTimer();

  /** Room beside its path. */
  final RoomState room = new RoomState();

  /** What a person cleared. */
  final ClearedStops cleared = new ClearedStops();

  /** How much of it is stored. */
  final StoreLimit storing;

  private RobotRecord record;

  /**
   * @param now since when it is not heard
   */
  FloorRobot(
      RobotRecord record,
      OperatorSettings settings,
      ActorRef<RobotMessage> agent,
      StoreLimit storing,
      Instant now) {
    this.storing = storing;
    this.record = record;
    this.settings = settings;
    this.agent = agent;
    this.reported = new ReportedState(now);
  }

  RobotRecord record() {
    return record;
  }

  void setRecord(RobotRecord changed) {
    record = changed;
  }

  String name() {
    return record.name();
  }

  /** Kilograms that it may carry. */
  double maxLoad() {
    return reported.capabilities().allowedLoad(record);
  }

  boolean isHeard() {
    return reported.isHeard();
  }

  /** In service, hears, knows where it is, and is well. */
  boolean isFit() {
    return state().isFit();
  }

  /** What it shall drive now, if it is in service. */
  @Nullable DriveGoal activeGoal() {
    return settings.isInService() ? drive.goal() : null;
  }

  /** Whether it has no drive and was told none. */
  private boolean hasNoDrive() {
    return reported.drive() == 0 && !drive.order().isPending();
  }

  boolean isStanding() {
    boolean isStopped =
        reported.mode() == Mode.IDLE || (reported.mode() == Mode.HOLDING && !reported.isMoving());
    return isStopped && hasNoDrive();
  }

  /** Whether it has ended or given up its drive and is stopped, well or not. */
  boolean hasStopped() {
    return isHeard() && !reported.isMoving() && reported.mode() != Mode.DRIVING && hasNoDrive();
  }

  /** Whether it drives, or was just told to drive, there. */
  boolean isDrivingTo(DriveGoal wanted) {
    DriveOrder order = drive.order();
    StoredDrive told = order.storedDrive().orElse(null);
    return told != null
        && (order.isPending() || reported.drive() == told.seq())
        && told.phase() == wanted.phase()
        && Objects.equals(told.task(), wanted.task())
        && (order.knownGoal() == null || wanted.goal().equals(order.knownGoal()));
  }

  /** Ends its drive, once. */
  void cancelDrive() {
    if (reported.isConnected() && !drive.isCancelling()) {
      drive.cancel();
      log.info("{}: its drive {} is not wanted any more.", name(), reported.drive());
      agent.tell(new RobotMessage.Cancel(reported.report().task()));
    }
  }

  RobotState state() {
    LastReport report = reported.report();
    return new RobotCondition(
            settings.isInService(),
            report.at() != null,
            isHeard(),
            report.localised(),
            report.mode(),
            obedience.fault() != null,
            charging.isCharging())
        .state();
  }

  /**
   * @param work its part in the mission that it belongs to
   */
  RobotView view(@Nullable DriveGoal work, RemainingPath path) {
    return new RobotView(
        record,
        reported.capabilities(),
        state(),
        new RobotView.Work(
            work == null ? null : work.task(),
            work == null ? Phase.NONE : work.phase(),
            hold.isHeld(),
            charging.turn().map(Turn::point).orElse(null),
            activity(work),
            manual.driver()),
        reported.report().telemetry(),
        path,
        reported.alert() == null ? charging.alert() : reported.alert(),
        reported.unreachable());
  }

  private Sentence activity(@Nullable DriveGoal work) {
    return switch (state()) {
      case CONNECTING ->
          Objects.requireNonNullElse(
              reported.unreachable(), Phrase.TRYING_TO_REACH.with(record.host(), record.port()));
      case LOST ->
          Phrase.LOST.with(
              Objects.requireNonNullElse(reported.unreachable(), Phrase.NOTHING_HEARD.with()),
              (reported.pose() == null ? Phrase.NOBODY_KNOWS_WHERE : Phrase.PLACE_STAYS_RESERVED)
                  .with());
      case NOT_LOCALISED ->
          Phrase.MUST_BE_LOCALISED.with(
              (reported.pose() == null ? Phrase.NO_PLACE_RESERVED : Phrase.PLACE_STAYS_RESERVED)
                  .with());
      case ERROR -> errorActivity();
      case OUT_OF_SERVICE -> Phrase.STAYS_OUT_OF_SERVICE.with(outOfServicePhrase().with());
      case IDLE, DRIVING, HOLDING, CHARGING -> operationalActivity(work);
    };
  }

  private Sentence errorActivity() {
    Sentence fault = obedience.fault();
    if (reported.mode() != Mode.ERROR && fault != null) {
      return Phrase.IS_LEFT_OUT.with(fault, RobotEvent.LEFT_OUT_FOR.toMinutes());
    }
    return reported.report().errors().isEmpty()
        ? Phrase.HAS_ERROR.with()
        : Phrase.HAS_FAULT.with(reported.report().errors().getFirst().text());
  }

  private Sentence operationalActivity(@Nullable DriveGoal work) {
    Sentence held = hold.reason();
    if (held != null) {
      return held;
    }
    String driver = manual.driver();
    if (driver != null) {
      return Phrase.DRIVEN_BY_HAND.with(driver);
    }
    Sentence charges = charging.status();
    if (charges != null && (charging.isForTask() || work == null || work.task() == null)) {
      return Objects.requireNonNullElse(drive.waitReason(), charges);
    }
    return work == null ? Phrase.IS_FREE.with() : workSentence(work);
  }

  private Phrase outOfServicePhrase() {
    if (isHeard()) {
      return Phrase.STAYS_WITHOUT_TASK;
    }
    return reported.pose() == null ? Phrase.PLACE_IS_FREE : Phrase.PLACE_STAYS_UNTIL_SAID;
  }

  /** Of its certificate, 64 digits; null: it was never paired. */
  @Nullable String fingerprint() {
    Fingerprint known = record.fingerprint();
    return known == null ? null : known.hex();
  }

  /** Why it has stopped on its path, or its group has, as it reports it; null where it drives. */
  @Nullable String reportedStopReason() {
    LastReport report = reported.report();
    boolean isAlone = report.role() == Role.ALONE;
    if (isAlone && (report.mode() != Mode.DRIVING || report.moving())) {
      return null;
    }
    return report.errors().stream()
        .filter(fault -> !isAlone || STOPS_ON_PATH.contains(fault.code()))
        .map(Fault::text)
        .findFirst()
        .orElse(null);
  }

  private Sentence workSentence(DriveGoal work) {
    Sentence waits = drive.waitReason();
    if (waits != null) {
      return waits;
    }
    String reason = reportedStopReason();
    if (reason != null) {
      return Sentence.verbatim(reason);
    }
    Long task = work.task();
    if (task == null) {
      return Phrase.DRIVES_HOME.with();
    }
    ArmState armed = reported.report().readings().arm();
    if (armed != null && armed.act() != null) {
      return (work.phase() == Phase.TO_OBJECT ? Phrase.ARM_PICKS_UP : Phrase.ARM_PLACES).with(task);
    }
    return switch (work.phase()) {
      case NONE -> Phrase.DRIVES_HOME.with();
      case TO_OBJECT ->
          (work.isWithoutLoad() ? Phrase.DRIVES_FOR_TASK : Phrase.DRIVES_TO_LOAD).with(task);
      case TO_GOAL -> Phrase.CARRIES_LOAD.with(task);
      case HOME -> Phrase.DRIVES_HOME_FROM.with(task);
    };
  }
}
