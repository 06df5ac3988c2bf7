package org.toqa.agent.formation;

import java.util.Locale;
import java.util.Optional;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.drive.DriveRules;
import org.toqa.formation.Follower;
import org.toqa.formation.Follower.Trouble;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.LeaderPose;

/** A robot's part as a follower. Times are seconds on the daemon's monotonic clock. */
public final class FormationFollower {

  private final Follow order;
  private final Follower follower;
  private long lastSeq;

  public FormationFollower(Follow order, AgentConfig.Following following) {
    this.order = order;
    this.follower =
        new Follower(following.law(), order.offset(), order.tolerance(), following.linkDelay());
  }

  public Follow order() {
    return order;
  }

  /** A new connection of the leader, which counts its poses anew. */
  public void resetSequence() {
    lastSeq = 0;
  }

  /** A pose that is no newer than the last one, or lies off any map, counts for nothing. */
  public void recordLeaderPose(LeaderPose pose, double now) {
    if (pose.seq() > lastSeq && DriveRules.isOnAnyMap(pose.pose())) {
      lastSeq = pose.seq();
      follower.receive(pose.pose(), pose.twist().twist(), now);
    }
  }

  /**
   * @param actual where the robot is, map frame
   * @return the velocity to command, in the robot's frame
   */
  public Twist steer(Pose actual, double now) {
    return follower.steer(actual, now);
  }

  /** Whether its leader has told it a pose, and not so long ago that it counts as lost. */
  public boolean hasLeaderInSight() {
    Trouble trouble = follower.trouble().orElse(null);
    return trouble != Trouble.NO_LEADER_YET && trouble != Trouble.LEADER_LOST;
  }

  /** It does not even try to come to its place. */
  public boolean isStopped() {
    Trouble trouble = follower.trouble().orElse(null);
    return trouble == Trouble.LEADER_LOST || trouble == Trouble.TOO_FAR;
  }

  /** Metres off its place; 0 before its leader's first pose. */
  public double error() {
    return follower.error();
  }

  public FollowerReport report(Pose actual, Mode mode) {
    return new FollowerReport(order.task(), lastSeq, actual, follower.error(), mode);
  }

  /** Why it is not where it should be; empty while it is, and before its leader's first pose. */
  public Optional<Fault> fault() {
    return follower
        .trouble()
        .filter(trouble -> trouble != Trouble.NO_LEADER_YET)
        .map(
            trouble ->
                trouble == Trouble.LEADER_LOST
                    ? new Fault(
                        "LEADER_LOST",
                        "The robot has stopped: it hears nothing from %s."
                            .formatted(order.leader()))
                    : new Fault(
                        "OUT_OF_PLACE",
                        String.format(
                            Locale.ROOT,
                            trouble == Trouble.TOO_FAR
                                ? "The robot has stopped: it is %.2f m from its place beside %s."
                                : "The robot is %.2f m from its place beside %s.",
                            follower.error(),
                            order.leader())));
  }
}
