package org.toqa.agent.formation;

import java.util.Optional;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.formation.FormationMonitor;
import org.toqa.formation.Verdict;
import org.toqa.formation.Verdict.Drive;
import org.toqa.formation.Verdict.Stop;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.Lead;

/**
 * A robot's part as the leader of a formation: how fast it may drive for its followers' sake. Times
 * are seconds on the daemon's monotonic clock.
 */
public final class FormationLeader {

  private static final double LONGEST_ARRIVAL_SECONDS = 3;

  private final Lead order;
  private final MotionLimits limits;
  private final FormationMonitor watch;
  private double reach;
  private double arrivalSeconds = Double.NaN;

  public FormationLeader(Lead order, MotionLimits limits) {
    this.order = order;
    this.limits = limits;
    watch =
        new FormationMonitor(
            order.followers().stream().map(Follower::robot).toList(), order.tolerance());
  }

  public Lead order() {
    return order;
  }

  /**
   * Notes a follower's answer; those to another task's formation are ignored.
   *
   * @param own where the leader is, map frame
   * @param now when it was received, seconds
   */
  public void recordReport(String follower, FollowerReport keep, Pose own, double now) {
    if (keep.task() == order.task()) {
      watch.recordAnswer(follower, keep.error(), keep.mode() == Mode.FOLLOWING, now);
      reach = Math.max(reach, own.distanceTo(keep.pose()));
    }
  }

  /** How fast the path may be driven, as a share of the planned speed; 0 to stop. */
  public double pace(double now) {
    return watch.verdict(now) instanceof Drive(double pace) ? pace : 0;
  }

  /**
   * How abruptly the velocity may change at that moment; while the group has to stop, all that
   * wheels can.
   */
  public PaceLimits paceLimits(double now) {
    PaceLimits gentle = PaceLimits.forLeader(limits, Math.max(reach, limits.speed()));
    return watch.verdict(now) instanceof Stop ? gentle.withBraking() : gentle;
  }

  /**
   * At the goal the formation ends when each follower has come to its place, or after a while.
   * Asked at every tick from the arrival on.
   */
  public boolean canEnd(double now) {
    arrivalSeconds = Double.isNaN(arrivalSeconds) ? now : arrivalSeconds;
    return watch.isInPlace() || now - arrivalSeconds > LONGEST_ARRIVAL_SECONDS;
  }

  /** Why the group has stopped; empty while it may drive. */
  public Optional<Fault> fault(double now) {
    Verdict verdict = watch.verdict(now);
    return verdict instanceof Stop(Verdict.Reason reason, String follower)
        ? Optional.of(new Fault("FORMATION_STOPPED", sentence(reason, follower)))
        : Optional.empty();
  }

  private static String sentence(Verdict.Reason reason, String follower) {
    String sentence =
        switch (reason) {
          case NOT_READY -> "The group waits for %s, which has not answered yet.";
          case LATE -> "The group has stopped: %s does not answer.";
          case NOT_FOLLOWING -> "The group has stopped: %s cannot follow.";
          case OUT_OF_PLACE -> "The group has stopped: %s is too far from its place.";
        };
    return sentence.formatted(follower);
  }
}
