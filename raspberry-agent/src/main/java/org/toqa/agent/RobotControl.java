package org.toqa.agent;

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
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Keep;
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
import org.toqa.link.message.ServerMessage.FromLeader;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
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
final class RobotControl {

  private static final Logger log = LoggerFactory.getLogger(RobotControl.class);
  private static final Pose ORIGIN = new Pose(0, 0, 0);

  private final AgentConfig config;
  private final DriveRules rules;
  private final FormationRules formationRules;
  private final Journal journal;
  private Lookout lookout;
  private ChassisReading body;

  private @Nullable SegmentRunner runner;
  private boolean last;
  private boolean cancelled;
  private boolean silent;
  private @Nullable Fault interrupted;
  private @Nullable LeaderPart leader;
  private @Nullable FollowerPart follower;
  private double now;

  /**
   * @param encrypted whether the link is
   * @throws IOException if the journal cannot be written: such a robot is not started
   */
  RobotControl(AgentConfig config, Journal journal, ChassisReading body, boolean encrypted)
      throws IOException {
    this.config = config;
    this.rules = new DriveRules(config.limits());
    this.formationRules = new FormationRules(config, encrypted);
    this.journal = journal;
    this.lookout = new Lookout(config.footprint() / 2);
    this.body = body;
    if (!journal.secure(recovered())) {
      throw new IOException(journal.fault().orElseThrow().text());
    }
  }

  private JournalEntry recovered() {
    if (journal.entry().isEmpty()) {
      return JournalEntry.of(body.powerCycle(), body.placedAt());
    }
    JournalEntry old = memory();
    if (old.drive() != 0) {
      interrupted =
          new Fault(
              "RESTARTED",
              "The daemon was restarted during drive %d, after %d of its segments; it waits for a new drive."
                  .formatted(old.drive(), old.segment()));
      log.warn("{}: {}", config.name(), interrupted.text());
    }
    return old.drivenNoMore()
        .anchoredAt(
            body.powerCycle(),
            old.powerCycle() == body.powerCycle() ? old.anchor() : body.placedAt());
  }

  /**
   * Takes in what the body says; to be called first in every tick.
   *
   * @param seconds on a monotonic clock
   */
  void sense(ChassisReading reading, double seconds) {
    now = seconds;
    if (reading.powerCycle() != body.powerCycle()) {
      lostPower(reading);
    }
    body = reading;
    lookout.see(reading.ranges(), pose(), seconds);
  }

  private void lostPower(ChassisReading reading) {
    log.warn("{}: the body was powered up anew.", who());
    runner = null;
    leader = null;
    follower = null;
    journal.secure(memory().drivenNoMore().anchoredAt(reading.powerCycle(), reading.placedAt()));
  }

  private JournalEntry memory() {
    return journal.entry().orElseThrow();
  }

  private boolean isLocalised() {
    return anchor() != null;
  }

  private @Nullable Pose anchor() {
    return memory().powerCycle() == body.powerCycle() ? memory().anchor() : null;
  }

  /** Map frame; an arbitrary frame while the robot is not localised. */
  Pose pose() {
    Pose anchor = anchor();
    return anchor == null ? body.odometry() : anchor.compose(body.odometry());
  }

  Optional<PhaseEnd> done() {
    return Optional.ofNullable(memory().done());
  }

  /** Kilograms on board. */
  double load() {
    return memory().load();
  }

  /** The answer to a command, which has its effect by then. */
  AgentMessage obey(Command command) {
    if (command instanceof Ping || command.seq() <= memory().lastSeq()) {
      return new Ack(command.seq());
    }
    Optional<String> objection = objectionTo(command);
    if (objection.isEmpty()) {
      if (isRemembered(command)) {
        begin(command);
        return new Ack(command.seq());
      }
      objection = Optional.of("The robot cannot write its journal, so it did nothing.");
    }
    log.warn(
        "{}: refused {} {}: {}",
        who(),
        command.getClass().getSimpleName(),
        command.seq(),
        objection.get());
    return new Reject(command.seq(), objection.get());
  }

  private boolean isRemembered(Command command) {
    JournalEntry next = after(command).accepted(command.seq());
    return switch (command) {
      case Extend _, Release _ -> journal.save(next); // it drives, and must not wait for the disk
      default -> journal.secure(next);
    };
  }

  /** The server has stored the end of this drive. */
  void acknowledged(long drive) {
    PhaseEnd done = memory().done();
    if (done == null || done.drive() != drive) {
      return;
    }
    boolean isTaskOver = done.phase() == 3 && memory().drive() == 0;
    journal.secure(isTaskOver ? memory().released() : memory().doneAcknowledged());
  }

  /**
   * Drives on.
   *
   * @param seconds since the last call
   * @param serverSilent whether the server was not heard for too long
   * @return the velocity to command, in the robot's frame
   */
  Twist drive(double seconds, boolean serverSilent) {
    silent = serverSilent;
    boolean onward = !memory().held() && !cancelled && body.faults().isEmpty();
    if (follower != null) {
      Twist command = follower.steer(pose(), now);
      return onward ? command : Twist.ZERO;
    }
    if (runner == null) {
      return Twist.ZERO;
    }
    Way way = runner.way();
    if (leader == null) {
      lookout.guide(way, seconds, onward);
    } else {
      lookout.guideLeader(way);
      way.limit(leader.paceLimits(now));
    }
    double pace = leader == null ? 1 : leader.pace(now);
    Twist command = runner.steer(pose(), seconds, onward ? pace : 0);
    if (cancelled) {
      endCancelledWhenItStands(way);
    } else if (last && runner.isAtEnd() && (leader == null || leader.mayEnd(now))) {
      endPhase();
    } else if (way.completed() != memory().segment()) {
      journal.save(memory().at(way.completed()));
    }
    return runner == null || !body.faults().isEmpty() ? Twist.ZERO : command;
  }

  private void endCancelledWhenItStands(Way way) {
    if (way.stands() && body.stands()) {
      runner = null;
    }
  }

  private void endPhase() {
    if (journal.secure(memory().phaseEnded())) {
      runner = null;
      leader = null;
      follower = null;
      log.info("{}: phase {} is done.", who(), memory().phase());
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
              .or(() -> rules.objectionTo(extend, Objects.requireNonNull(runner).way()));
      case Release release ->
          objectionToChanging(release.drive())
              .or(() -> rules.objectionTo(release, Objects.requireNonNull(runner).way()));
      case Locate locate ->
          runner == null && follower == null && body.stands()
              ? rules.objectionTo(locate)
              : Optional.of("A robot that drives cannot be told where it is; send cancel first.");
      case Lead lead -> objectionToDriving().or(() -> formationRules.objectionTo(lead));
      case Follow follow -> objectionToDriving().or(() -> formationRules.objectionTo(follow));
      case Hold _, Resume _, Cancel _, Ping _ -> Optional.empty();
    };
  }

  private Optional<String> objectionToDriving() {
    if (!body.faults().isEmpty()) {
      return Optional.of("The robot cannot drive: " + body.faults().getFirst().text());
    }
    if (!isLocalised()) {
      return Optional.of("The robot does not know where it is; send locate first.");
    }
    if (follower != null) {
      return Optional.of(
          "The robot follows %s; wait for the formation's end or send cancel."
              .formatted(follower.order().leader()));
    }
    if (runner != null && !cancelled) {
      return Optional.of(
          "The robot has not ended drive %d; wait for its end or send cancel."
              .formatted(memory().drive()));
    }
    return runner == null && body.stands()
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
    if (runner != null && memory().drive() == drive) {
      return Optional.empty();
    }
    return Optional.of(
        memory().drive() == 0
            ? "There is no drive %d any more; the robot has none.".formatted(drive)
            : "There is no drive %d any more; the robot has drive %d."
                .formatted(drive, memory().drive()));
  }

  private JournalEntry after(Command command) {
    return switch (command) {
      case Drive drive -> memory().driving(drive.seq(), drive.task(), drive.phase(), drive.load());
      case Follow follow -> memory().driving(follow.seq(), follow.task(), 2, 0);
      case Hold _ -> memory().holding(true);
      case Resume _ -> memory().holding(false);
      case Cancel cancel ->
          Objects.equals(cancel.task(), memory().task()) ? memory().released() : memory();
      case Locate locate ->
          // anchor * odometry = pose
          memory()
              .anchoredAt(
                  body.powerCycle(), locate.pose().compose(body.odometry().relative(ORIGIN)));
      case Extend _, Release _, Lead _, Ping _ -> memory();
    };
  }

  private void begin(Command command) {
    switch (command) {
      case Drive drive -> begin(drive);
      case Extend extend -> {
        Objects.requireNonNull(runner)
            .way()
            .replace(extend.from(), extend.segments(), extend.released());
        last = extend.last();
      }
      case Release release -> Objects.requireNonNull(runner).way().release(release.released());
      case Lead lead -> {
        leader = new LeaderPart(lead, config.limits());
        log.info("{}: leads task {}, {} followers.", who(), lead.task(), lead.followers().size());
      }
      case Follow follow -> {
        follower = new FollowerPart(follow, config.following());
        interrupted = null;
        log.info("{}: follows {}.", who(), follow.leader());
      }
      case Cancel cancel -> {
        leader = leader != null && isFor(cancel, leader.order().task()) ? null : leader;
        follower = follower != null && isFor(cancel, follower.order().task()) ? null : follower;
        cancelled = runner != null && memory().drive() == 0;
        interrupted = memory().task() == null ? null : interrupted;
      }
      case Locate _ -> log.info("{}: told to be at {}.", config.name(), pose());
      case Hold _, Resume _, Ping _ -> {}
    }
  }

  private static boolean isFor(Cancel cancel, long task) {
    return Objects.equals(cancel.task(), task);
  }

  private void begin(Drive drive) {
    lookout = new Lookout(config.footprint() / 2);
    runner =
        new SegmentRunner(
            new Way(
                drive.start(),
                drive.segments(),
                drive.released(),
                PaceLimits.alone(config.limits())),
            lookout);
    last = drive.last();
    cancelled = false;
    interrupted = null;
    log.info(
        "{}: drive {} of phase {}, {} segments, {} released.",
        who(),
        drive.seq(),
        drive.phase(),
        drive.segments().size(),
        drive.released());
  }

  private String who() {
    return memory().task() == null ? config.name() : config.name() + " task " + memory().task();
  }

  /** What this robot leads; empty where it is no leader. */
  Optional<Lead> leading() {
    return Optional.ofNullable(leader).map(LeaderPart::order);
  }

  /** A follower has answered this leader. */
  void heard(FollowerLink.Answer answer) {
    if (leader != null) {
      leader.heard(answer.follower(), answer.keep(), pose(), now);
    }
  }

  /** As a leader it stops for a follower's sake, and still moves. */
  boolean isBraking() {
    return leader != null && leader.pace(now) == 0 && runner != null && !runner.way().stands();
  }

  /** How it is about to move, in its own frame. */
  Twist planned() {
    return runner == null ? Twist.ZERO : runner.way().twist();
  }

  /** The leader, or who says so, has connected anew. */
  void leaderConnected() {
    if (follower != null) {
      follower.connected();
    }
  }

  /** The leader has spoken. */
  void heard(FromLeader message) {
    if (follower == null || follower.order().task() != message.task()) {
      return;
    }
    switch (message) {
      case LeaderPose pose -> follower.heard(pose, now);
      case FormationEnd _ -> endPhase();
    }
  }

  /** The answer to a leader's message; empty where it is none of this robot's leader. */
  Optional<Keep> answer(FromLeader message) {
    return switch (message) {
      case LeaderPose pose when follower != null && follower.order().task() == pose.task() ->
          Optional.of(follower.keep(pose(), mode()));
      case LeaderPose _ -> Optional.empty();
      case FormationEnd end when follower != null && follower.order().task() == end.task() ->
          Optional.empty(); // the journal could not be written; the leader says it again
      case FormationEnd(long task) -> Optional.of(new Keep(task, 0, pose(), 0, mode()));
    };
  }

  private Role role() {
    if (follower != null) {
      return Role.FOLLOWER;
    }
    return leader == null ? Role.ALONE : Role.LEADER;
  }

  private Mode mode() {
    if (!body.faults().isEmpty()) {
      return Mode.ERROR;
    }
    if (follower != null) {
      return memory().held() || follower.isStopped() ? Mode.HOLDING : Mode.FOLLOWING;
    }
    if (memory().held() || isHeldBySilence()) {
      return Mode.HOLDING;
    }
    return runner == null ? Mode.IDLE : Mode.DRIVING;
  }

  /** Whether its body stands, and nothing but a word from outside would move it. */
  boolean isAtRest() {
    return body.stands() && (mode() == Mode.IDLE || mode() == Mode.HOLDING);
  }

  private boolean isHeldBySilence() {
    return silent
        && runner != null
        && runner.way().completed() == runner.way().released()
        && runner.way().stands();
  }

  private List<Fault> errors() {
    List<Fault> errors = new ArrayList<>(body.faults());
    if (interrupted != null) {
      errors.add(interrupted);
    }
    journal.fault().ifPresent(errors::add);
    if (leader != null && runner != null) {
      leader.fault(now).ifPresent(errors::add);
    }
    if (follower != null) {
      follower.fault().ifPresent(errors::add);
    }
    lookout.fault().ifPresent(errors::add);
    if (runner != null && runner.isOffWay()) {
      errors.add(
          new Fault(
              "OFF_WAY",
              String.format(Locale.ROOT, "The robot is %.2f m off its way.", runner.error())));
    }
    return errors;
  }

  RobotReport report() {
    return new RobotReport(
        config,
        memory(),
        body,
        isLocalised(),
        pose(),
        mode(),
        role(),
        runner == null || cancelled ? 0 : runner.way().completed(),
        runner == null || cancelled ? 0 : runner.way().released(),
        lookout.obstacles(),
        errors());
  }
}
