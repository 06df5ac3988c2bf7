package org.toqa.agent.control;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ArmConfig;
import org.toqa.agent.drive.ObstacleAvoider;
import org.toqa.agent.formation.FollowerLink;
import org.toqa.agent.formation.FormationFollower;
import org.toqa.agent.formation.FormationLeader;
import org.toqa.agent.storage.Journal;
import org.toqa.arm.ArmCommand;
import org.toqa.arm.ArmReading;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.FormationEnd;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.LeaderMessage;
import org.toqa.link.message.ServerMessage.LeaderPose;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.message.ServerMessage.Room;

/**
 * What the robot does: obeys commands that are legal, drives along its trajectory, and reports. A
 * command is written to the journal before it has an effect, and has no effect if that fails.
 *
 * <p>Rules beyond the message's own text:
 *
 * <ul>
 *   <li>A ping has no effect, so it does not count as the last sequence number.
 *   <li>A drive that is accepted shows that the server knows of the end of the one before.
 *   <li>{@code cancel} names what the robot shall not work for any more; a robot that does not work
 *       for it acknowledges and goes on. A robot that drives comes to a standstill on its path.
 *   <li>A hold outlasts drives and restarts until {@code resume}; a drive that comes meanwhile is
 *       accepted and waits.
 *   <li>A stop of the body's own is ended at the robot or by {@code clear}, and ends the drive: the
 *       robot keeps task and phase, and waits for a new drive from where it is.
 *   <li>A daemon that starts anew does not continue its last drive: it stays stopped, keeps task
 *       and phase, reports them in its hello, and waits for a new drive from where it is. What
 *       moved while no daemon watched is known by odometry, but nobody has looked whether the path
 *       is still free.
 *   <li>In a formation the leader's drive is phase 2 of its task, and the followers have none: a
 *       follower's phase ends by its leader's message. A follower keeps its place while the server
 *       is silent, since its leader stops when nothing more is released.
 *   <li>A robot that accepts {@code follow} leads no more.
 *   <li>An arm acts where a drive has ended. A hold stops it on its way, {@code cancel} ends what
 *       it does; after a restart, or a stop of the body's own, it stands until it is told the same
 *       anew. With its arm out the robot does not drive: it folds it first. An arm that does not
 *       come to its rest is a stop like those of the body.
 *   <li>A phase 3 whose end is acknowledged ends the task for this robot.
 * </ul>
 *
 * <p>For the thread of the ticks.
 */
public final class RobotControl {

  private static final Logger log = LoggerFactory.getLogger(RobotControl.class);

  private final AgentConfig config;
  private final RobotRecord record;
  private final CommandRules rules;
  private final Consumer<Set<String>> stopClearer;
  private ObstacleAvoider avoider;
  private final @Nullable ArmWork arm;
  private Activity activity = Alone.IDLE;
  private boolean isServerSilent;
  private double now;
  private long lastPath;

  /**
   * @param encrypted whether the link is
   * @param stopClearer is told which of the body's stops a person has cleared
   * @param armReading of its arm; null: it has none
   * @throws IOException if the journal cannot be written: such a robot is not started
   */
  public RobotControl(
      AgentConfig config,
      Journal journal,
      ChassisReading body,
      boolean encrypted,
      Consumer<Set<String>> stopClearer,
      @Nullable ArmReading armReading)
      throws IOException {
    this.config = config;
    this.stopClearer = stopClearer;
    this.record = new RobotRecord(config.name(), journal, body);
    this.rules = new CommandRules(config, encrypted, record);
    ArmConfig mounted = config.arm();
    this.arm =
        mounted == null || armReading == null ? null : new ArmWork(mounted.arm(), armReading);
    this.avoider = newAvoider();
  }

  /**
   * Takes the body's reading; to be called first in every tick.
   *
   * @param seconds on a monotonic clock
   */
  public void update(ChassisReading reading, double seconds) {
    now = seconds;
    if (record.update(withFaultOfArm(reading))) {
      activity = Alone.IDLE;
      if (arm != null) {
        arm.cancel();
      }
    }
    avoider.observe(reading.ranges(), pose(), seconds);
  }

  private ChassisReading withFaultOfArm(ChassisReading reading) {
    if (arm == null || arm.fault().isEmpty()) {
      return reading;
    }
    List<Fault> faults = new ArrayList<>(reading.faults());
    faults.add(arm.fault().get());
    return reading.withFaults(faults);
  }

  /** Map frame; an arbitrary frame while the robot is not localised. */
  public Pose pose() {
    return record.pose();
  }

  /** The map's pose of the origin of the body's odometry; null while the robot is not localised. */
  public @Nullable Pose anchor() {
    return record.anchor();
  }

  /** The last phase that was driven to its end, until the server has stored that. */
  public Optional<PhaseEnd> done() {
    return Optional.ofNullable(record.entry().done());
  }

  /** Kilograms on board. */
  public double load() {
    return record.entry().load();
  }

  /** What it carries together with others. */
  public Optional<SharedLoad> sharedLoad() {
    return activity.sharedLoad();
  }

  /**
   * The answer to a command: an {@code Ack}, and it has its effect by then, or a {@code Reject}
   * with the reason, and nothing has changed.
   */
  public AgentMessage execute(Command command) {
    if (command instanceof Ping || command.seq() <= record.entry().lastSeq()) {
      return new Ack(command.seq());
    }
    return switch (check(command)) {
      case CommandCheck.Accepted(Runnable effect) -> obey(command, effect);
      case CommandCheck.Refused(String reason) -> refuse(command, reason);
    };
  }

  private AgentMessage obey(Command command, Runnable effect) {
    if (!record.saveAccepted(command)) {
      return refuse(command, "The robot cannot write its journal, so it did nothing.");
    }
    effect.run();
    return new Ack(command.seq());
  }

  private AgentMessage refuse(Command command, String reason) {
    log.warn(
        "{}: refused {} {}: {}",
        record.logName(),
        command.getClass().getSimpleName(),
        command.seq(),
        reason);
    return new Reject(command.seq(), reason);
  }

  private CommandCheck check(Command command) {
    return switch (command) {
      case Drive drive ->
          CommandCheck.of(rules.objectionTo(drive, activity, arm), () -> begin(drive));
      case Extend extend ->
          checkChange(
              extend.drive(),
              run ->
                  CommandCheck.of(
                      rules.objectionTo(extend, run, activity), () -> run.extend(extend)));
      case Release release ->
          checkChange(
              release.drive(),
              run ->
                  CommandCheck.of(
                      rules.objectionTo(release, run),
                      () -> run.trajectory().release(release.released())));
      case Room room ->
          checkChange(
              room.drive(),
              run -> CommandCheck.of(rules.objectionTo(room, run, activity), () -> run.lend(room)));
      case Locate locate ->
          CommandCheck.of(
              rules.objectionTo(locate, activity),
              () -> log.info("{}: told to be at {}.", config.name(), pose()));
      case Lead lead -> CommandCheck.of(rules.objectionTo(lead, activity, arm), () -> begin(lead));
      case Follow follow ->
          CommandCheck.of(rules.objectionTo(follow, activity, arm), () -> begin(follow));
      case Act act -> {
        Act last = record.entry().act();
        boolean isRepeated =
            last != null && last.task() == act.task() && last.action() == act.action();
        yield CommandCheck.of(rules.objectionTo(act, activity, arm), () -> begin(act, isRepeated));
      }
      case Cancel cancel -> new CommandCheck.Accepted(() -> cancel(cancel));
      case Clear clear ->
          CommandCheck.of(rules.objectionTo(clear), () -> clear(Set.copyOf(clear.reasons())));
      case Hold _, Resume _, Ping _ -> new CommandCheck.Accepted(() -> {});
    };
  }

  private void clear(Set<String> stops) {
    stopClearer.accept(stops);
    if (arm != null && arm.fault().filter(fault -> stops.contains(fault.code())).isPresent()) {
      arm.cancel();
    }
  }

  private CommandCheck checkChange(long drive, Function<DriveRun, CommandCheck> change) {
    return switch (rules.find(drive, activity)) {
      case CommandRules.NamedDrive.Found(DriveRun run) -> change.apply(run);
      case CommandRules.NamedDrive.NotFound(String sentence) -> new CommandCheck.Refused(sentence);
    };
  }

  private void begin(Drive order) {
    avoider = newAvoider();
    Optional<DriveRun> drive = Optional.of(new DriveRun(order, config, avoider, () -> ++lastPath));
    activity =
        activity instanceof Leading(var leader, _) ? new Leading(leader, drive) : new Alone(drive);
    log.info(
        "{}: drive {} of phase {}, {} segments, {} released.",
        record.logName(),
        order.seq(),
        order.phase(),
        order.segments().size(),
        order.released());
  }

  private ObstacleAvoider newAvoider() {
    return new ObstacleAvoider(
        config.footprint() / 2,
        config.kind(),
        config.rangeSensors(),
        config.limits().acceleration());
  }

  private void begin(Act order, boolean isRepeated) {
    if (arm != null) {
      arm.begin(order, pose(), isRepeated);
      log.info("{}: act {}, {}.", record.logName(), order.seq(), order.action());
    }
  }

  private void begin(Lead order) {
    activity = new Leading(new FormationLeader(order, config.limits()), Optional.empty());
    log.info(
        "{}: leads task {}, {} followers.",
        record.logName(),
        order.task(),
        order.followers().size());
  }

  private void begin(Follow order) {
    activity = new Following(new FormationFollower(order, config.following()));
    log.info("{}: follows {}.", record.logName(), order.leader());
  }

  private void cancel(Cancel order) {
    if (arm != null && arm.order().isPresent() && record.entry().act() == null) {
      arm.cancel();
    }
    activity = activity.cancel(order.task());
    if (record.entry().drive() == 0) {
      activity.drive().ifPresent(DriveRun::cancel);
    }
  }

  /**
   * Records that the server has stored the end of a drive.
   *
   * @param drive its sequence number
   */
  public void acknowledgeDone(long drive) {
    record.acknowledgeDone(drive);
  }

  /**
   * Drives on.
   *
   * @param seconds since the last call
   * @param serverSilent whether nothing came from the server for too long
   * @return what to command the body
   */
  public ChassisCommand drive(double seconds, boolean serverSilent) {
    isServerSilent = serverSilent;
    boolean canMove = canMove() && isArmFolded();
    ChassisCommand command =
        activity.steer(new Activity.Tick(record.reading(), pose(), seconds, now, canMove));
    Optional<DriveRun> drive = activity.drive();
    drive.ifPresent(this::updateProgress);
    boolean hasEnded = drive.isPresent() && activity.drive().isEmpty();
    return hasEnded || hasBodyFault()
        ? ChassisCommand.MoveAt.STANDSTILL
        : command.within(config.limits());
  }

  private boolean canMove() {
    return !record.entry().held() && !hasBodyFault();
  }

  /** No robot drives with its arm out; one that shall drive folds it first. */
  private boolean isArmFolded() {
    if (arm == null || arm.isFolded()) {
      return true;
    }
    if (activity.drive().isPresent() || activity instanceof Following) {
      arm.fold();
    }
    return false;
  }

  /**
   * Moves the arm on, and records how what it did ended.
   *
   * @param seconds since the last call
   * @param reading of the arm
   * @return what to command the arm
   */
  public ArmCommand moveArm(double seconds, ArmReading reading) {
    if (arm == null) {
      throw new IllegalStateException("it has no arm");
    }
    ArmCommand command = arm.advance(seconds, reading, canMove());
    ArmWork moved = arm;
    arm.end()
        .filter(record::saveActEnd)
        .ifPresent(
            end -> {
              log.info(
                  "{}: act {} has ended{}.",
                  record.logName(),
                  end.act(),
                  end.failure() == null ? "" : ": " + end.failure().code());
              moved.endAct();
            });
    return command;
  }

  /** How the last act ended, until the server has stored that. */
  public Optional<ActEnd> acted() {
    return Optional.ofNullable(record.entry().acted());
  }

  /**
   * Kilograms that the load of what the arm does has, as was ordered.
   *
   * @return empty: it does nothing
   */
  public OptionalDouble orderedLoad() {
    return arm == null || arm.order().isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(arm.order().get().load());
  }

  /**
   * Records that the server has stored the end of an act.
   *
   * @param act its sequence number
   */
  public void acknowledgeActed(long act) {
    record.acknowledgeActed(act);
  }

  private boolean hasBodyFault() {
    return !record.reading().faults().isEmpty();
  }

  private void updateProgress(DriveRun drive) {
    if (drive.isCancelled()) {
      if (drive.isStanding() && record.reading().isStanding()) {
        activity = activity.withoutDrive();
      }
    } else if (activity.isPhaseOver(now)) {
      endPhase();
    } else {
      record.saveSegment(drive.trajectory().completedCount());
    }
  }

  private void endPhase() {
    if (record.savePhaseEnd()) {
      log.info(
          "{}: phase {} is done{}.",
          record.logName(),
          record.entry().phase(),
          activity.drive().map(run -> ", " + run.summary(pose())).orElse(""));
      activity = Alone.IDLE;
    }
  }

  /** What this robot leads; empty where it is no leader. */
  public Optional<Lead> leadOrder() {
    return activity instanceof Leading(var leader, _)
        ? Optional.of(leader.order())
        : Optional.empty();
  }

  /** A follower has answered this leader. */
  public void handle(FollowerLink.Answer answer) {
    if (activity instanceof Leading(var leader, _)) {
      leader.recordReport(answer.follower(), answer.report(), pose(), now);
    }
  }

  /** As a leader it stops for a follower's sake, and still moves. */
  public boolean isBraking() {
    return activity instanceof Leading leading && leading.isBraking(now);
  }

  /** How it is about to move, in its own frame. */
  public Twist plannedTwist() {
    return activity.drive().map(run -> run.trajectory().twist()).orElse(Twist.ZERO);
  }

  /**
   * Whether it follows a leader that it has heard of late: one that is lost may never come back.
   */
  public boolean hasLeaderInSight() {
    return activity instanceof Following(var follower) && follower.hasLeaderInSight();
  }

  /** The leader, or another that says it is, has connected anew. */
  public void leaderConnected() {
    if (activity instanceof Following(var follower)) {
      follower.resetSequence();
    }
  }

  /** The leader has sent a message. */
  public void handle(LeaderMessage message) {
    if (!(activity instanceof Following following && following.isFor(message.task()))) {
      return;
    }
    switch (message) {
      case LeaderPose pose -> following.follower().recordLeaderPose(pose, now);
      case FormationEnd _ -> endPhase();
    }
  }

  /** The answer to a leader's message; empty where it is none of this robot's leader. */
  public Optional<FollowerReport> answerTo(LeaderMessage message) {
    if (activity instanceof Following following && following.isFor(message.task())) {
      return switch (message) {
        case LeaderPose _ -> Optional.of(following.follower().report(pose(), mode()));
        case FormationEnd _ -> Optional.empty(); // the journal failed; the leader says it again
      };
    }
    return switch (message) {
      case LeaderPose _ -> Optional.empty();
      case FormationEnd(long task) -> Optional.of(new FollowerReport(task, 0, pose(), 0, mode()));
    };
  }

  private Mode mode() {
    if (hasBodyFault()) {
      return Mode.ERROR;
    }
    boolean isHeld = record.entry().held();
    return switch (activity) {
      case Following(var follower) ->
          isHeld || follower.isStopped() ? Mode.HOLDING : Mode.FOLLOWING;
      case Alone _, Leading _ -> {
        if (isHeld || isWaitingForServer()) {
          yield Mode.HOLDING;
        }
        yield activity.drive().isEmpty() ? Mode.IDLE : Mode.DRIVING;
      }
    };
  }

  private boolean isWaitingForServer() {
    return isServerSilent && activity.drive().filter(DriveRun::isWaitingForRelease).isPresent();
  }

  /** Whether its body is stopped, and nothing but a message from outside would move it. */
  public boolean isAtRest() {
    return (arm == null || arm.isAtRest())
        && record.reading().isStanding()
        && (mode() == Mode.IDLE || mode() == Mode.HOLDING);
  }

  private List<Fault> faults() {
    List<Fault> faults = new ArrayList<>(record.faults());
    activity.fault(now).ifPresent(faults::add);
    avoider.fault().ifPresent(faults::add);
    activity.drive().flatMap(DriveRun::fault).ifPresent(faults::add);
    return faults;
  }

  /** The robot as it is now. */
  public RobotReport report() {
    return new RobotReport(
        config,
        record.entry(),
        record.reading(),
        record.isLocalised(),
        pose(),
        mode(),
        activity.role(),
        activity.drive().map(DriveRun::reportedSegment).orElse(0),
        activity.drive().map(DriveRun::reportedRelease).orElse(0),
        avoider.obstacles(),
        activity.drive().flatMap(DriveRun::zone).map(_ -> RoomUse.HELD).orElse(avoider.roomUse()),
        activity.drive().flatMap(DriveRun::zone).or(avoider::room).orElse(null),
        activity instanceof Following following ? following.follower().error() : null,
        arm == null ? null : arm.state(),
        faults());
  }
}
