package org.toqa.agent;

import java.util.Optional;
import org.toqa.formation.FormationWatch;
import org.toqa.formation.Verdict;
import org.toqa.formation.Verdict.Onward;
import org.toqa.formation.Verdict.Stop;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Keep;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;

/**
 * A robot's part as the leader of a formation: how fast it may drive for its followers' sake. Times
 * are seconds on the daemon's monotonic clock.
 */
final class LeaderPart {

  private static final double LONGEST_ARRIVAL_SECONDS = 3;

  private final Lead order;
  private final MotionLimits limits;
  private final FormationWatch watch;
  private double reach;
  private double arrived = Double.NaN;

  LeaderPart(Lead order, MotionLimits limits) {
    this.order = order;
    this.limits = limits;
    watch =
        new FormationWatch(
            order.followers().stream().map(Follower::robot).toList(), order.tolerance());
  }

  Lead order() {
    return order;
  }

  /**
   * @param own where the leader is, map frame
   */
  void heard(String follower, Keep keep, Pose own, double now) {
    if (keep.task() == order.task()) {
      watch.answered(follower, keep.error(), keep.mode() == Mode.FOLLOWING, now);
      reach = Math.max(reach, own.distanceTo(keep.pose()));
    }
  }

  /** How fast the way may be driven, as a share of the planned speed; 0 to stand. */
  double pace(double now) {
    return watch.verdict(now) instanceof Onward(double pace) ? pace : 0;
  }

  PaceLimits paceLimits(double now) {
    PaceLimits gentle = PaceLimits.leading(limits, Math.max(reach, limits.speed()));
    return watch.verdict(now) instanceof Stop ? gentle.braking() : gentle;
  }

  /**
   * At the goal the formation ends when each follower has come to its place, or after a while.
   * Asked at every tick from the arrival on.
   */
  boolean mayEnd(double now) {
    arrived = Double.isNaN(arrived) ? now : arrived;
    return watch.isCalm() || now - arrived > LONGEST_ARRIVAL_SECONDS;
  }

  /** Why the group stands; empty while it may drive. */
  Optional<Fault> fault(double now) {
    Verdict verdict = watch.verdict(now);
    return verdict instanceof Stop(Verdict.Reason reason, String follower)
        ? Optional.of(new Fault("FORMATION_STOPPED", sentence(reason, follower)))
        : Optional.empty();
  }

  private static String sentence(Verdict.Reason reason, String follower) {
    String sentence =
        switch (reason) {
          case NOT_READY -> "The group waits for %s, which has not answered yet.";
          case LATE -> "The group stands: %s does not answer.";
          case NOT_FOLLOWING -> "The group stands: %s cannot follow.";
          case OUT_OF_PLACE -> "The group stands: %s is too far from its place.";
        };
    return sentence.formatted(follower);
  }
}
