package org.toqa.agent.control;

import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.control.Activity.Tick;
import org.toqa.agent.drive.FreeCrossing;
import org.toqa.agent.drive.ObstacleAvoider;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.PassingRoom;

/**
 * The current drive: its trajectory, whether it ends its phase, and whether it was cancelled. A
 * cancelled drive comes to a standstill on its path and is then dropped.
 *
 * <p>The body of a robot alone drives the released segments by itself. The daemon steers it where
 * it must steer beside the path: round obstacles, back to a path that it has come off, and the last
 * millimetres to where it stands. It steers leaders all the while.
 */
final class DriveRun {

  /** Ticks without an obstacle, 0.2 s, after which the body drives by itself again. */
  private static final int CALM_TICKS = 10;

  private final AgentConfig config;
  private final SegmentRunner runner;
  private final PathRelay relay;
  private final ObstacleAvoider avoider;
  private boolean isFinal;
  private boolean isCancelled;
  private int calmTicks = CALM_TICKS;

  /** A free zone that the robot finds its own way through; null: none. */
  private @Nullable PassingRoom zone;

  /** Its way through that; null: it has not come there. */
  private @Nullable FreeCrossing crossing;

  /** Metres that the body has driven by itself, and those at the daemon's velocities. */
  private double byItself;

  private double steered;

  /**
   * @param config of the robot
   * @param avoider has seen nothing yet
   * @param pathNumbers of the paths that the body is given: a higher one at each call
   */
  DriveRun(Drive order, AgentConfig config, ObstacleAvoider avoider, LongSupplier pathNumbers) {
    this.config = config;
    this.avoider = avoider;
    PaceLimits alone = PaceLimits.forSingleRobot(config.limits());
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(order.start(), order.segments(), order.released(), alone),
            config.kind(),
            avoider);
    relay = new PathRelay(runner.trajectory(), alone, pathNumbers);
    isFinal = order.last();
  }

  ReferenceTrajectory trajectory() {
    return runner.trajectory();
  }

  void extend(Extend order) {
    trajectory().replace(order.from(), order.segments(), order.released());
    isFinal = order.last();
  }

  void lend(Room order) {
    if (order.zone() == null) {
      avoider.lend(new PassingRoom(order.from(), order.to(), order.left(), order.right()));
    } else {
      zone = new PassingRoom(order.from(), order.to(), 0, 0, order.zone());
      crossing = null;
    }
  }

  /** The free zone that it was lent and has not left. */
  Optional<PassingRoom> zone() {
    return isCancelled ? Optional.empty() : Optional.ofNullable(zone);
  }

  void cancel() {
    isCancelled = true;
  }

  boolean isCancelled() {
    return isCancelled;
  }

  /**
   * Drives on by one tick, beside or up to obstacles.
   *
   * @return what to command the body
   */
  ChassisCommand steer(Tick tick) {
    boolean canMove = canMove(tick);
    PassingRoom lent = zone;
    if (lent != null && trajectory().completedCount() >= lent.from()) {
      return cross(lent, tick);
    }
    count(tick, relay.isActive());
    relay.update(tick.reading(), tick.pose());
    avoider.avoidObstacles(trajectory(), tick.seconds(), canMove);
    calmTicks = avoider.isActive() || runner.isOffPath() ? 0 : calmTicks + 1;
    if (relay.isActive() && !canGoOn(canMove)) {
      relay.stop();
    } else if (!relay.isActive() && canBegin(canMove)) {
      relay.begin(tick.reading(), tick.pose());
    }
    if (relay.isActive()) {
      runner.watch(tick.pose());
      return relay.command(canMove);
    }
    Twist wanted =
        runner.steer(tick.pose(), tick.seconds(), canMove ? avoider.pace(trajectory()) : 0);
    return new MoveAt(avoider.guarded(tick.pose(), wanted));
  }

  /** Drives on by one tick, as it finds its way. */
  private ChassisCommand cross(PassingRoom lent, Tick tick) {
    FreeCrossing way = crossing;
    if (way == null) {
      relay.stop();
      way =
          new FreeCrossing(
              Objects.requireNonNull(lent.zone()),
              trajectory().startOf(lent.to()),
              config.limits(),
              config.footprint() / 2,
              config.chassis().track(config.kind()),
              tick.reading().twist());
      crossing = way;
    }
    count(tick, false);
    Twist velocity = way.step(tick.pose(), tick.reading().ranges(), tick.seconds(), canMove(tick));
    trajectory().setProgress(progress(lent, way), 0, isCancelled && !isStanding(tick) ? 1 : 0);
    if (way.isOver()) {
      trajectory().setProgress(lent.to(), 0, 0);
      runner.restart();
      zone = null;
      crossing = null;
    }
    return new MoveAt(velocity);
  }

  private static boolean isStanding(Tick tick) {
    return tick.reading().isStanding();
  }

  /** The segments count as completed whose ends are farther from where it leaves the zone. */
  private int progress(PassingRoom lent, FreeCrossing way) {
    Pose exit = trajectory().startOf(lent.to());
    int completed = trajectory().completedCount();
    while (completed < lent.to() - 1
        && trajectory().startOf(completed + 1).distanceTo(exit) >= way.nearest()) {
      completed++;
    }
    return completed;
  }

  private boolean canBegin(boolean canMove) {
    return canMove && calmTicks >= CALM_TICKS && hasMore();
  }

  /** A body that may not move slows down by itself, if it has begun. */
  private boolean canGoOn(boolean canMove) {
    boolean isOver = relay.isSettled() && !(canMove && hasMore());
    return calmTicks > 0 && !isOver && (canMove || relay.isAccepted());
  }

  private boolean hasMore() {
    return trajectory().completedCount() < trajectory().releasedCount();
  }

  /**
   * The same, but only up to obstacles.
   *
   * @param limits that hold from now on
   * @param pace as a share of the planned speed, 0 to 1
   */
  ChassisCommand steerAsLeader(Tick tick, PaceLimits limits, double pace) {
    count(tick, false);
    avoider.stopForObstacles(trajectory());
    trajectory().setLimits(limits);
    return new MoveAt(runner.steer(tick.pose(), tick.seconds(), canMove(tick) ? pace : 0));
  }

  private void count(Tick tick, boolean isByItself) {
    double metres = Math.hypot(tick.reading().twist().vx(), tick.reading().twist().vy());
    byItself += isByItself ? metres * tick.seconds() : 0;
    steered += isByItself ? 0 : metres * tick.seconds();
  }

  /**
   * How it was driven, for the log.
   *
   * @param pose where the robot is, map frame
   */
  String summary(Pose pose) {
    return String.format(
        Locale.ROOT,
        "%.4f m from the end of its path; the body drove %.2f m by itself, %.2f m at velocities",
        trajectory().pose().distanceTo(pose),
        byItself,
        steered);
  }

  private boolean canMove(Tick tick) {
    return tick.canMove() && !isCancelled;
  }

  /** Whether the robot is at the end of the last drive of its phase. */
  boolean isAtEndOfPhase() {
    return isFinal && runner.isAtEnd();
  }

  /** Whether the reference is stopped. */
  boolean isStanding() {
    return trajectory().isStanding();
  }

  /** Whether the reference is stopped at the end of what is released. */
  boolean isWaitingForRelease() {
    return trajectory().completedCount() == trajectory().releasedCount() && isStanding();
  }

  /** How many segments the reference has completed; 0 when cancelled. */
  int reportedSegment() {
    return isCancelled ? 0 : trajectory().completedCount();
  }

  /** How many segments may be driven; 0 when cancelled. */
  int reportedRelease() {
    return isCancelled ? 0 : trajectory().releasedCount();
  }

  /** That the robot stands because it is too far beside its path; empty while it does not. */
  Optional<Fault> fault() {
    FreeCrossing way = crossing;
    if (way != null && way.isStuck()) {
      return Optional.of(
          new Fault(
              "ZONE_STUCK",
              String.format(
                  Locale.ROOT,
                  "The robot comes no nearer than %.2f m to where it leaves the free zone; it waits for another path.",
                  way.nearest())));
    }
    return runner.isOffPath()
        ? Optional.of(
            new Fault(
                "OFF_WAY",
                String.format(
                    Locale.ROOT,
                    "The robot is %.2f m off its path; it stands.",
                    runner.deviation())))
        : Optional.empty();
  }
}
