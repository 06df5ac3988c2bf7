package org.toqa.agent.control;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.drive.DriveRules;
import org.toqa.agent.drive.ObstacleAvoider;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.agent.formation.FollowerLink;
import org.toqa.agent.formation.FormationFollower;
import org.toqa.agent.formation.FormationLeader;
import org.toqa.agent.formation.FormationRules;
import org.toqa.agent.storage.Journal;
import org.toqa.agent.storage.JournalEntry;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.ServerMessage.Cancel;
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

/**
 * What the robot does: obeys commands that are legal, drives its way, and knows what of it must
 * outlive the daemon. A command is written to the journal before it has an effect, and has no
 * effect if that fails.
 *
 * <p>Rules beyond the message's own text:
 *
 * <ul>
 *   <li>A ping has no effect, so it does not count as the last sequence number.
 *   <li>A drive that is accepted tells that the server knows of the end of the one before.
 *   <li>{@code cancel} names what the robot shall not work for any more; a robot that does not work
 *       for it acknowledges and goes on. A robot that drives comes to a stand on its way.
 *   <li>A hold outlasts drives and restarts until {@code resume}; a drive that comes meanwhile is
 *       accepted and waits.
 *   <li>A daemon that starts anew does not go on with the drive under way: it stands, keeps task
 *       and phase, tells so in its hello, and waits for a new drive from where it is. What moved
 *       while no daemon watched is known by odometry, but nobody has looked whether the way is
 *       still free.
 *   <li>In a formation the leader's drive is phase 2 of its task, and the followers have none: a
 *       follower's phase ends with its leader's word. A follower keeps its place while the server
 *       is silent, since its leader stands when nothing more is released.
 *   <li>A phase 3 whose end is acknowledged ends the task for this robot.
 * </ul>
 */
public final class RobotControl {

  private static final Logger log = LoggerFactory.getLogger(RobotControl.class);
  private static final Pose ORIGIN = new Pose(0, 0, 0);

  private final AgentConfig config;
  private final DriveRules rules;
  private final FormationRules formationRules;
  private final Journal journal;
  private ObstacleAvoider avoider;
  private ChassisReading lastReading;

  private @Nullable SegmentRunner runner;
  private boolean isFinal;
  private boolean isCancelled;
  private boolean isServerSilent;
  private @Nullable Fault restartFault;
  private @Nullable FormationLeader leader;
  private @Nullable FormationFollower follower;
  private double now;

  /**
   * @param encrypted whether the link is
   * @throws IOException if the journal cannot be written: such a robot is not started
   */
  public RobotControl(AgentConfig config, Journal journal, ChassisReading body, boolean encrypted)
      throws IOException {
    this.config = config;
    this.rules = new DriveRules(config.limits());
    this.formationRules = new FormationRules(config, encrypted);
    this.journal = journal;
    this.avoider = new ObstacleAvoider(config.footprint() / 2);
    this.lastReading = body;
    if (!journal.saveDurably(recoverEntry())) {
      throw new IOException(journal.fault().orElseThrow().text());
    }
  }

  private JournalEntry recoverEntry() {
    if (journal.entry().isEmpty()) {
      return JournalEntry.of(lastReading.powerCycle(), lastReading.startPose());
    }
    JournalEntry old = entry();
    if (old.drive() != 0) {
      restartFault =
          new Fault(
              "RESTARTED",
              "The daemon was restarted during drive %d, after %d of its segments; it waits for a new drive."
                  .formatted(old.drive(), old.segment()));
      log.warn("{}: {}", config.name(), restartFault.text());
    }
    return old.withoutDrive()
        .withAnchor(
            lastReading.powerCycle(),
            old.powerCycle() == lastReading.powerCycle() ? old.anchor() : lastReading.startPose());
  }

  /**
   * Takes in what the body says; to be called first in every tick.
   *
   * @param seconds on a monotonic clock
   */
  public void update(ChassisReading reading, double seconds) {
    now = seconds;
    if (reading.powerCycle() != lastReading.powerCycle()) {
      endActivityAfterPowerCycle(reading);
    }
    lastReading = reading;
    avoider.observe(reading.ranges(), pose(), seconds);
  }

  private void endActivityAfterPowerCycle(ChassisReading reading) {
    log.warn("{}: the body was powered up anew.", logName());
    runner = null;
    leader = null;
    follower = null;
    journal.saveDurably(
        entry().withoutDrive().withAnchor(reading.powerCycle(), reading.startPose()));
  }

  private JournalEntry entry() {
    return journal.entry().orElseThrow();
  }

  private boolean isLocalised() {
    return anchor() != null;
  }

  private @Nullable Pose anchor() {
    return entry().powerCycle() == lastReading.powerCycle() ? entry().anchor() : null;
  }

  /** Map frame; an arbitrary frame while the robot is not localised. */
  public Pose pose() {
    Pose anchor = anchor();
    return anchor == null ? lastReading.odometry() : anchor.compose(lastReading.odometry());
  }

  public Optional<PhaseEnd> done() {
    return Optional.ofNullable(entry().done());
  }

  /** Kilograms on board. */
  public double load() {
    return entry().load();
  }

  /** The answer to a command, which has its effect by then. */
  public AgentMessage execute(Command command) {
    if (command instanceof Ping || command.seq() <= entry().lastSeq()) {
      return new Ack(command.seq());
    }
    Optional<String> objection = objectionTo(command);
    if (objection.isEmpty()) {
      if (saveAccepted(command)) {
        begin(command);
        return new Ack(command.seq());
      }
      objection = Optional.of("The robot cannot write its journal, so it did nothing.");
    }
    log.warn(
        "{}: refused {} {}: {}",
        logName(),
        command.getClass().getSimpleName(),
        command.seq(),
        objection.get());
    return new Reject(command.seq(), objection.get());
  }

  private boolean saveAccepted(Command command) {
    JournalEntry next = entryAfter(command).withLastSeq(command.seq());
    return switch (command) {
      case Extend _, Release _ -> journal.save(next); // it drives, and must not wait for the disk
      default -> journal.saveDurably(next);
    };
  }

  /** The server has stored the end of this drive. */
  public void acknowledgeDone(long drive) {
    PhaseEnd done = entry().done();
    if (done == null || done.drive() != drive) {
      return;
    }
    boolean isTaskOver = done.phase() == 3 && entry().drive() == 0;
    journal.saveDurably(isTaskOver ? entry().withoutTask() : entry().withoutDone());
  }

  /**
   * Drives on.
   *
   * @param seconds since the last call
   * @param serverSilent whether the server was not heard for too long
   * @return the velocity to command, in the robot's frame
   */
  public Twist drive(double seconds, boolean serverSilent) {
    isServerSilent = serverSilent;
    boolean canMove = !entry().held() && !isCancelled && lastReading.faults().isEmpty();
    if (follower != null) {
      Twist command = follower.steer(pose(), now);
      return canMove ? command : Twist.ZERO;
    }
    if (runner == null) {
      return Twist.ZERO;
    }
    ReferenceTrajectory trajectory = runner.trajectory();
    if (leader == null) {
      avoider.avoidObstacles(trajectory, seconds, canMove);
    } else {
      avoider.stopForObstacles(trajectory);
      trajectory.setLimits(leader.paceLimits(now));
    }
    double pace = leader == null ? 1 : leader.pace(now);
    Twist command = runner.steer(pose(), seconds, canMove ? pace : 0);
    if (isCancelled) {
      endCancelledDriveIfStanding(trajectory);
    } else if (isFinal && runner.isAtEnd() && (leader == null || leader.canEnd(now))) {
      endPhase();
    } else if (trajectory.completedCount() != entry().segment()) {
      journal.save(entry().withSegment(trajectory.completedCount()));
    }
    return runner == null || !lastReading.faults().isEmpty() ? Twist.ZERO : command;
  }

  private void endCancelledDriveIfStanding(ReferenceTrajectory trajectory) {
    if (trajectory.isStanding() && lastReading.isStanding()) {
      runner = null;
    }
  }

  private void endPhase() {
    if (journal.saveDurably(entry().withPhaseEnd())) {
      runner = null;
      leader = null;
      follower = null;
      log.info("{}: phase {} is done.", logName(), entry().phase());
    }
  }

  private Optional<String> objectionTo(Command command) {
    return switch (command) {
      case Drive drive ->
          objectionToDriving()
              .or(() -> objectionAsLeader(drive))
              .or(() -> rules.objectionTo(drive, pose()));
      case Extend extend ->
          objectionToChanging(extend.drive())
              .or(() -> rules.objectionTo(extend, Objects.requireNonNull(runner).trajectory()));
      case Release release ->
          objectionToChanging(release.drive())
              .or(() -> rules.objectionTo(release, Objects.requireNonNull(runner).trajectory()));
      case Locate locate ->
          runner == null && follower == null && lastReading.isStanding()
              ? rules.objectionTo(locate)
              : Optional.of("A robot that drives cannot be told where it is; send cancel first.");
      case Lead lead -> objectionToDriving().or(() -> formationRules.objectionTo(lead));
      case Follow follow -> objectionToDriving().or(() -> formationRules.objectionTo(follow));
      case Hold _, Resume _, Cancel _, Ping _ -> Optional.empty();
    };
  }

  private Optional<String> objectionToDriving() {
    if (!lastReading.faults().isEmpty()) {
      return Optional.of("The robot cannot drive: " + lastReading.faults().getFirst().text());
    }
    if (!isLocalised()) {
      return Optional.of("The robot does not know where it is; send locate first.");
    }
    if (follower != null) {
      return Optional.of(
          "The robot follows %s; wait for the formation's end or send cancel."
              .formatted(follower.order().leader()));
    }
    if (runner != null && !isCancelled) {
      return Optional.of(
          "The robot has not ended drive %d; wait for its end or send cancel."
              .formatted(entry().drive()));
    }
    return runner == null && lastReading.isStanding()
        ? Optional.empty()
        : Optional.of("The robot is still moving; wait until it stands.");
  }

  private Optional<String> objectionAsLeader(Drive drive) {
    boolean fits =
        leader == null
            || (drive.phase() == 2 && Objects.equals(drive.task(), leader.order().task()));
    return fits
        ? Optional.empty()
        : Optional.of(
            "The robot leads phase 2 of task %d; send cancel first."
                .formatted(Objects.requireNonNull(leader).order().task()));
  }

  private Optional<String> objectionToChanging(long drive) {
    if (runner != null && entry().drive() == drive) {
      return Optional.empty();
    }
    return Optional.of(
        entry().drive() == 0
            ? "There is no drive %d any more; the robot has none.".formatted(drive)
            : "There is no drive %d any more; the robot has drive %d."
                .formatted(drive, entry().drive()));
  }

  private JournalEntry entryAfter(Command command) {
    return switch (command) {
      case Drive drive -> entry().withDrive(drive.seq(), drive.task(), drive.phase(), drive.load());
      case Follow follow -> entry().withDrive(follow.seq(), follow.task(), 2, 0);
      case Hold _ -> entry().withHold(true);
      case Resume _ -> entry().withHold(false);
      case Cancel cancel ->
          Objects.equals(cancel.task(), entry().task()) ? entry().withoutTask() : entry();
      case Locate locate ->
          // anchor * odometry = pose
          entry()
              .withAnchor(
                  lastReading.powerCycle(),
                  locate.pose().compose(lastReading.odometry().relative(ORIGIN)));
      case Extend _, Release _, Lead _, Ping _ -> entry();
    };
  }

  private void begin(Command command) {
    switch (command) {
      case Drive drive -> begin(drive);
      case Extend extend -> {
        Objects.requireNonNull(runner)
            .trajectory()
            .replace(extend.from(), extend.segments(), extend.released());
        isFinal = extend.last();
      }
      case Release release ->
          Objects.requireNonNull(runner).trajectory().release(release.released());
      case Lead lead -> {
        leader = new FormationLeader(lead, config.limits());
        log.info(
            "{}: leads task {}, {} followers.", logName(), lead.task(), lead.followers().size());
      }
      case Follow follow -> {
        follower = new FormationFollower(follow, config.following());
        restartFault = null;
        log.info("{}: follows {}.", logName(), follow.leader());
      }
      case Cancel cancel -> {
        leader = leader != null && isFor(cancel, leader.order().task()) ? null : leader;
        follower = follower != null && isFor(cancel, follower.order().task()) ? null : follower;
        isCancelled = runner != null && entry().drive() == 0;
        restartFault = entry().task() == null ? null : restartFault;
      }
      case Locate _ -> log.info("{}: told to be at {}.", config.name(), pose());
      case Hold _, Resume _, Ping _ -> {}
    }
  }

  private static boolean isFor(Cancel cancel, long task) {
    return Objects.equals(cancel.task(), task);
  }

  private void begin(Drive drive) {
    avoider = new ObstacleAvoider(config.footprint() / 2);
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(
                drive.start(),
                drive.segments(),
                drive.released(),
                PaceLimits.forSingleRobot(config.limits())),
            avoider);
    isFinal = drive.last();
    isCancelled = false;
    restartFault = null;
    log.info(
        "{}: drive {} of phase {}, {} segments, {} released.",
        logName(),
        drive.seq(),
        drive.phase(),
        drive.segments().size(),
        drive.released());
  }

  private String logName() {
    return entry().task() == null ? config.name() : config.name() + " task " + entry().task();
  }

  /** What this robot leads; empty where it is no leader. */
  public Optional<Lead> leadOrder() {
    return Optional.ofNullable(leader).map(FormationLeader::order);
  }

  /** A follower has answered this leader. */
  public void handle(FollowerLink.Answer answer) {
    if (leader != null) {
      leader.recordReport(answer.follower(), answer.report(), pose(), now);
    }
  }

  /** As a leader it stops for a follower's sake, and still moves. */
  public boolean isBraking() {
    return leader != null
        && leader.pace(now) == 0
        && runner != null
        && !runner.trajectory().isStanding();
  }

  /** How it is about to move, in its own frame. */
  public Twist plannedTwist() {
    return runner == null ? Twist.ZERO : runner.trajectory().twist();
  }

  /** The leader, or who says so, has connected anew. */
  public void leaderConnected() {
    if (follower != null) {
      follower.resetSequence();
    }
  }

  /** The leader has spoken. */
  public void handle(LeaderMessage message) {
    if (follower == null || follower.order().task() != message.task()) {
      return;
    }
    switch (message) {
      case LeaderPose pose -> follower.recordLeaderPose(pose, now);
      case FormationEnd _ -> endPhase();
    }
  }

  /** The answer to a leader's message; empty where it is none of this robot's leader. */
  public Optional<FollowerReport> answerTo(LeaderMessage message) {
    return switch (message) {
      case LeaderPose pose when follower != null && follower.order().task() == pose.task() ->
          Optional.of(follower.report(pose(), mode()));
      case LeaderPose _ -> Optional.empty();
      case FormationEnd end when follower != null && follower.order().task() == end.task() ->
          Optional.empty(); // the journal could not be written; the leader says it again
      case FormationEnd(long task) -> Optional.of(new FollowerReport(task, 0, pose(), 0, mode()));
    };
  }

  private Role role() {
    if (follower != null) {
      return Role.FOLLOWER;
    }
    return leader == null ? Role.ALONE : Role.LEADER;
  }

  private Mode mode() {
    if (!lastReading.faults().isEmpty()) {
      return Mode.ERROR;
    }
    if (follower != null) {
      return entry().held() || follower.isStopped() ? Mode.HOLDING : Mode.FOLLOWING;
    }
    if (entry().held() || isWaitingForServer()) {
      return Mode.HOLDING;
    }
    return runner == null ? Mode.IDLE : Mode.DRIVING;
  }

  /** Whether its body stands, and nothing but a word from outside would move it. */
  public boolean isAtRest() {
    return lastReading.isStanding() && (mode() == Mode.IDLE || mode() == Mode.HOLDING);
  }

  private boolean isWaitingForServer() {
    return isServerSilent
        && runner != null
        && runner.trajectory().completedCount() == runner.trajectory().releasedCount()
        && runner.trajectory().isStanding();
  }

  private List<Fault> errors() {
    List<Fault> errors = new ArrayList<>(lastReading.faults());
    if (restartFault != null) {
      errors.add(restartFault);
    }
    journal.fault().ifPresent(errors::add);
    if (leader != null && runner != null) {
      leader.fault(now).ifPresent(errors::add);
    }
    if (follower != null) {
      follower.fault().ifPresent(errors::add);
    }
    avoider.fault().ifPresent(errors::add);
    if (runner != null && runner.isOffTrajectory()) {
      errors.add(
          new Fault(
              "OFF_WAY",
              String.format(
                  Locale.ROOT, "The robot is %.2f m off its way.", runner.trackingError())));
    }
    return errors;
  }

  public RobotReport report() {
    return new RobotReport(
        config,
        entry(),
        lastReading,
        isLocalised(),
        pose(),
        mode(),
        role(),
        runner == null || isCancelled ? 0 : runner.trajectory().completedCount(),
        runner == null || isCancelled ? 0 : runner.trajectory().releasedCount(),
        avoider.obstacles(),
        errors());
  }
}
