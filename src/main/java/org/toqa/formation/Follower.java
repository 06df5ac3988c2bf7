package org.toqa.formation;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * A robot that keeps its place beside a leader.
 *
 * <ol>
 *   <li>{@link #receive} whenever the leader has told where it is.
 *   <li>{@link #steer} at every tick; between two messages the leader is taken to move on as it
 *       did.
 * </ol>
 *
 * Times are seconds on one monotonic clock of the follower's.
 */
public final class Follower {

  /** A leader that is silent for longer is lost, and the follower stops (Tanta, level 2). */
  public static final double LOST_SECONDS = 0.6;

  /** Metres off its place from which a robot does not drive there by itself. */
  public static final double TOO_FAR = 0.5;

  /** Out of tolerance until the error is below this share of it. */
  private static final double RECOVERY_SHARE = 0.5;

  /** Why a follower does not keep its place. */
  public enum Trouble {
    NO_LEADER_YET,
    LEADER_LOST,
    OUT_OF_PLACE,
    TOO_FAR
  }

  private final FollowerLaw law;
  private final Vec2 offset;
  private final double tolerance;
  private final double linkDelay;
  private @Nullable LeaderState leader;
  private @Nullable Trouble trouble = Trouble.NO_LEADER_YET;
  private double lastReceived;
  private double error;

  /**
   * @param offset of its place, in the leader's frame, metres
   * @param tolerance metres off its place, above 0, from which the formation must stop
   * @param linkDelay seconds that a message usually takes, 0 or more
   */
  public Follower(FollowerLaw law, Vec2 offset, double tolerance, double linkDelay) {
    this.law = law;
    this.offset = offset;
    this.tolerance = tolerance;
    this.linkDelay = linkDelay;
  }

  /**
   * Notes where the leader was when it sent this.
   *
   * @param pose map frame
   * @param twist in the leader's frame
   * @param now when it was received, seconds on the follower's clock
   */
  public void receive(Pose pose, Twist twist, double now) {
    leader = new LeaderState(pose, twist, now - linkDelay);
    lastReceived = now;
  }

  /**
   * The velocity at this tick; zero without a leader, or too far off its place.
   *
   * @param actual where the robot is, map frame
   * @param now seconds on the follower's clock
   * @return the velocity to command, in the robot's frame
   */
  public Twist steer(Pose actual, double now) {
    if (leader == null) {
      return Twist.ZERO;
    }
    Pose place = leader.at(now).compose(new Pose(offset.x(), offset.y(), 0));
    error = place.distanceTo(actual);
    trouble = troubleAt(now);
    return trouble == Trouble.LEADER_LOST || trouble == Trouble.TOO_FAR
        ? Twist.ZERO
        : law.velocity(place, RigidMotion.at(offset, leader.twist()), actual);
  }

  private @Nullable Trouble troubleAt(double now) {
    if (now - lastReceived > LOST_SECONDS) {
      return Trouble.LEADER_LOST;
    }
    if (error > TOO_FAR) {
      return Trouble.TOO_FAR;
    }
    boolean wasOut = trouble != null && trouble != Trouble.NO_LEADER_YET;
    return error > tolerance * (wasOut ? RECOVERY_SHARE : 1) ? Trouble.OUT_OF_PLACE : null;
  }

  /** Metres between the robot and its place; 0 before the first message. */
  public double error() {
    return error;
  }

  /** Why it does not keep its place; empty while it does. */
  public Optional<Trouble> trouble() {
    return Optional.ofNullable(trouble);
  }
}
