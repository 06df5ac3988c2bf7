package org.toqa.app.bench;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.agent.drive.DriveRules;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.motion.DriveKind;
import org.toqa.sim.SimulatedFleet;

/**
 * A robot alone at the other end of a link: it drives by the daemon's own trajectories, limits and
 * rules over a simulated body, and answers and reports as a daemon does; without a journal, range
 * sensors and other robots to carry with. Its body is beside where it takes itself to be.
 */
final class DrivenRobot implements AutoCloseable {
  static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);
  private static final PaceLimits PACE = PaceLimits.forSingleRobot(LIMITS);
  private static final DriveRules RULES = new DriveRules(LIMITS, SimulatedFleet.FOOTPRINT / 2);
  private static final SimulatedWheels WHEELS = SimulatedWheels.omni(0, 0);
  private static final double MAX_LOAD = 5;

  /** As in the daemon's reports. */
  private static final long STATE_INTERVAL_NANOS = 190_000_000;

  private static final long DONE_INTERVAL_NANOS = 990_000_000;

  /** A body that was told to stand moves for so many ticks at most. */
  private static final int STOPPING_TICKS = 50;

  private final String name;
  private final double diameter;
  private final SimulatedBody body;
  private final PoseError error;
  private final Consumer<AgentMessage> sender;

  private @Nullable SegmentRunner runner;
  private boolean isFinal;
  private boolean isCancelled;
  private boolean held;
  private long lastSeq;
  private @Nullable Long task;
  private int phase;
  private long drive;
  private @Nullable PhaseEnd done;
  private Twist command = Twist.ZERO;
  private int ticksStanding;

  private @Nullable State lastState;
  private long lastStateNanos;
  private @Nullable PhaseEnd lastDone;
  private long lastDoneNanos;
  private double metres;

  /**
   * @param start where it takes itself to be, map frame
   * @param diameter metres
   * @param sender is given what the robot says
   */
  DrivenRobot(
      String name, Pose start, double diameter, PoseError error, Consumer<AgentMessage> sender) {
    this.name = name;
    this.diameter = diameter;
    this.body = new SimulatedBody(start, WHEELS, 0);
    this.error = error;
    this.sender = sender;
  }

  String name() {
    return name;
  }

  double diameter() {
    return diameter;
  }

  /** Where the middle of its body really is, map frame. */
  Vec2 truePosition() {
    return body.truePose().position().plus(error.offset());
  }

  /** Metres that it has driven. */
  double metres() {
    return metres;
  }

  /** What it says when a server connects. */
  Hello hello() {
    return new Hello(
        AgentMessage.VERSION,
        name,
        MAX_LOAD,
        LIMITS.speed(),
        LIMITS.turnRate(),
        diameter,
        0,
        DriveKind.OMNI.word(),
        0,
        true,
        body.pose(),
        mode(),
        task,
        phase,
        Role.ALONE,
        drive,
        segment(),
        released(),
        lastSeq,
        done);
  }

  /** The server has said something. */
  void receive(ServerMessage message) {
    if (message instanceof AckDone(long ended)) {
      acknowledgeDone(ended);
    } else if (message instanceof Command order) {
      sender.accept(execute(order));
    }
  }

  private void acknowledgeDone(long ended) {
    if (done != null && done.drive() == ended) {
      if (done.phase() == 3 && drive == 0) {
        task = null;
        phase = 0;
      }
      done = null;
    }
  }

  private AgentMessage execute(Command order) {
    if (order instanceof Ping || order.seq() <= lastSeq) {
      return new Ack(order.seq());
    }
    Optional<String> objection = objectionTo(order);
    if (objection.isPresent()) {
      return new Reject(order.seq(), objection.get());
    }
    lastSeq = order.seq();
    switch (order) {
      case Drive d -> begin(d);
      case Extend e -> {
        isFinal = e.last();
        trajectory().replace(e.from(), e.segments(), e.released());
      }
      case Release r -> trajectory().release(r.released());
      case Cancel c -> cancel(c);
      case Hold _ -> held = true;
      case Resume _ -> held = false;
      default -> {}
    }
    return new Ack(order.seq());
  }

  private Optional<String> objectionTo(Command order) {
    return switch (order) {
      case Drive d ->
          runner == null && body.isStanding()
              ? RULES.objectionTo(d, body.pose())
              : Optional.of("The robot has not ended its drive.");
      case Extend e -> hasDrive(e.drive()) ? RULES.objectionTo(e, trajectory()) : noDrive();
      case Release r -> hasDrive(r.drive()) ? RULES.objectionTo(r, trajectory()) : noDrive();
      case Cancel _, Hold _, Resume _, Ping _ -> Optional.empty();
      default -> Optional.of("This simulated robot only drives alone.");
    };
  }

  private boolean hasDrive(long number) {
    return runner != null && drive == number;
  }

  private static Optional<String> noDrive() {
    return Optional.of("There is no such drive any more.");
  }

  private ReferenceTrajectory trajectory() {
    return Objects.requireNonNull(runner).trajectory();
  }

  private void begin(Drive order) {
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(order.start(), order.segments(), order.released(), PACE),
            DriveKind.OMNI);
    isFinal = order.last();
    isCancelled = false;
    task = order.task();
    phase = order.phase();
    drive = order.seq();
    done = null;
  }

  private void cancel(Cancel order) {
    if (Objects.equals(order.task(), task)) {
      task = null;
      phase = 0;
      drive = 0;
      done = null;
      isCancelled = true;
    }
  }

  /**
   * Drives on by one tick, and says what is due.
   *
   * @param nanos of simulated time
   * @return whether its body may have moved
   */
  boolean tick(long nanos) {
    ticksStanding = command.equals(Twist.ZERO) ? ticksStanding + 1 : 0;
    boolean moves = ticksStanding <= STOPPING_TICKS;
    if (moves) {
      moveBody();
    }
    if (runner != null) {
      command = steer(runner);
    }
    report(nanos);
    return moves;
  }

  private void moveBody() {
    Pose before = body.truePose();
    body.setCommand(command);
    body.advance();
    double driven = before.distanceTo(body.truePose());
    error.advance(driven);
    metres += driven;
  }

  private Twist steer(SegmentRunner driving) {
    double pace = held || isCancelled ? 0 : 1;
    Twist wanted = LIMITS.clampedTwist(driving.steer(body.pose(), SimulatedBody.TICK, pace));
    if (isCancelled) {
      if (driving.trajectory().isStanding() && body.isStanding()) {
        runner = null;
      }
    } else if (isFinal && driving.isAtEnd()) {
      done = new PhaseEnd(task, phase, drive);
      drive = 0;
      runner = null;
    }
    return runner == null ? Twist.ZERO : wanted;
  }

  private void report(long nanos) {
    State before = lastState;
    if (before == null || nanos - lastStateNanos >= STATE_INTERVAL_NANOS || hasChanged(before)) {
      State state = state(nanos);
      sender.accept(state);
      lastState = state;
      lastStateNanos = nanos;
    }
    if (done != null && (!done.equals(lastDone) || nanos - lastDoneNanos >= DONE_INTERVAL_NANOS)) {
      sender.accept(new Done(done.task(), done.phase(), done.drive()));
      lastDoneNanos = nanos;
    }
    lastDone = done;
  }

  private boolean hasChanged(State before) {
    return before.mode() != mode()
        || before.drive() != drive
        || before.segment() != segment()
        || before.released() != released()
        || before.phase() != phase
        || !Objects.equals(before.task(), task)
        || before.errors().isEmpty() == isOffPath();
  }

  private State state(long nanos) {
    return new State(
        nanos / 1_000_000,
        true,
        body.pose(),
        Speed.of(body.twist()),
        mode(),
        task,
        phase,
        Role.ALONE,
        drive,
        segment(),
        released(),
        1,
        List.of(),
        List.of(),
        null,
        null,
        faults());
  }

  private Mode mode() {
    if (held) {
      return Mode.HOLDING;
    }
    return runner == null ? Mode.IDLE : Mode.DRIVING;
  }

  private int segment() {
    return runner == null || isCancelled ? 0 : runner.trajectory().completedCount();
  }

  private int released() {
    return runner == null || isCancelled ? 0 : runner.trajectory().releasedCount();
  }

  private boolean isOffPath() {
    return runner != null && runner.isOffPath();
  }

  private List<Fault> faults() {
    return runner != null && runner.isOffPath()
        ? List.of(
            new Fault(
                "OFF_WAY",
                String.format(
                    Locale.ROOT, "The robot is %.2f m off its path.", runner.deviation())))
        : List.of();
  }

  @Override
  public void close() {
    body.close();
  }
}
