package org.toqa.agent.formation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.ServerMessage.FormationEnd;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.LeaderPose;

/**
 * What a leader sends to its followers: its pose every 200 ms, and at the end the end of the
 * formation until each has answered. Times are nanoseconds on the daemon's monotonic clock. For one
 * thread.
 */
public final class FormationBroadcast implements AutoCloseable {

  /** A follower that does not know of the end by then is asked by its server. */
  private static final long END_TIMEOUT_NANOS = 10_000_000_000L;

  /** Two seconds of answers of the largest formation. */
  private static final int QUEUED_ANSWERS = 500;

  private final Lead order;
  private final BlockingQueue<FollowerLink.Answer> takeAnswers =
      new ArrayBlockingQueue<>(QUEUED_ANSWERS);
  private final List<FollowerLink> links = new ArrayList<>();
  private final Set<String> endAcknowledged = new HashSet<>();
  private long seq;
  private BroadcastTimer timer;
  private long endNanos;
  private boolean ending;

  public FormationBroadcast(String leader, Lead order, FollowerConnector connector, long nanos) {
    this.order = order;
    this.timer = new BroadcastTimer(nanos);
    order.followers().forEach(f -> links.add(new FollowerLink(leader, f, connector, takeAnswers)));
  }

  public Lead order() {
    return order;
  }

  /** What the followers have answered since the last call. */
  public List<FollowerLink.Answer> takeAnswers() {
    List<FollowerLink.Answer> taken = new ArrayList<>();
    takeAnswers.drainTo(taken);
    return taken;
  }

  /**
   * Sends where the leader is, if it is time.
   *
   * @param stamp milliseconds since 1970
   * @param pose map frame
   * @param braking whether the leader stops for a follower's sake and still moves
   */
  public void sendPose(Pose pose, Twist twist, boolean braking, long stamp, long nanos) {
    if (timer.fireIfDue(braking, nanos)) {
      LeaderPose message = new LeaderPose(order.task(), ++seq, stamp, pose, Speed.of(twist));
      links.forEach(link -> link.send(message));
    }
  }

  /** From now on it sends the end of the formation. */
  public void beginEnd(long nanos) {
    ending = true;
    endNanos = nanos;
    timer = new BroadcastTimer(nanos);
  }

  /** Sends the end of the formation, if it is time, until {@link #isOver}. */
  public void sendEnd(long nanos) {
    for (FollowerLink.Answer answer : takeAnswers()) {
      if (answer.report().seq() == 0) {
        endAcknowledged.add(answer.follower());
      }
    }
    if (timer.fireIfDue(false, nanos)) {
      links.stream()
          .filter(link -> !endAcknowledged.contains(link.follower()))
          .forEach(link -> link.send(new FormationEnd(order.task())));
    }
  }

  /** Whether every follower knows of the end, or has had time enough. */
  public boolean isOver(long nanos) {
    return ending
        && (endAcknowledged.size() == links.size() || nanos - endNanos > END_TIMEOUT_NANOS);
  }

  @Override
  public void close() {
    links.forEach(FollowerLink::close);
  }
}
