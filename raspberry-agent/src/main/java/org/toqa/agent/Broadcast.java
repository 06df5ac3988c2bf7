package org.toqa.agent;

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
 * A leader's word to its followers: its pose every 200 ms, and at the end the end of the formation
 * until each has answered. For one thread.
 */
final class Broadcast implements AutoCloseable {

  /** A follower that has not heard of the end by then has a server that asks what became of it. */
  private static final long LONGEST_END_NANOS = 10_000_000_000L;

  /** Two seconds of answers of the largest formation. */
  private static final int QUEUED_ANSWERS = 500;

  private final Lead order;
  private final BlockingQueue<FollowerLink.Answer> answers =
      new ArrayBlockingQueue<>(QUEUED_ANSWERS);
  private final List<FollowerLink> links = new ArrayList<>();
  private final Set<String> released = new HashSet<>();
  private long seq;
  private BroadcastPace pace;
  private long endNanos;
  private boolean ending;

  Broadcast(String leader, Lead order, Dialer dialer, long nanos) {
    this.order = order;
    this.pace = new BroadcastPace(nanos);
    order.followers().forEach(f -> links.add(new FollowerLink(leader, f, dialer, answers)));
  }

  Lead order() {
    return order;
  }

  /** What the followers have answered since the last call. */
  List<FollowerLink.Answer> answers() {
    List<FollowerLink.Answer> heard = new ArrayList<>();
    answers.drainTo(heard);
    return heard;
  }

  /**
   * Tells where the leader is, if it is time.
   *
   * @param stamp milliseconds since 1970
   * @param place map frame
   * @param braking whether the leader stops for a follower's sake and still moves
   */
  void tell(Pose place, Twist twist, boolean braking, long stamp, long nanos) {
    if (pace.isTime(braking, nanos)) {
      LeaderPose message =
          new LeaderPose(order.task(), ++seq, stamp, place, new Speed(twist.vx(), twist.w()));
      links.forEach(link -> link.send(message));
    }
  }

  /** From now on it tells of the end. */
  void end(long nanos) {
    ending = true;
    endNanos = nanos;
    pace = new BroadcastPace(nanos);
  }

  /** Tells of the end, if it is time, until {@link #isOver}. */
  void tellEnd(long nanos) {
    for (FollowerLink.Answer answer : answers()) {
      if (answer.keep().seq() == 0) {
        released.add(answer.follower());
      }
    }
    if (pace.isTime(false, nanos)) {
      links.stream()
          .filter(link -> !released.contains(link.follower()))
          .forEach(link -> link.send(new FormationEnd(order.task())));
    }
  }

  /** Whether every follower knows of the end, or has had time enough. */
  boolean isOver(long nanos) {
    return ending && (released.size() == links.size() || nanos - endNanos > LONGEST_END_NANOS);
  }

  @Override
  public void close() {
    links.forEach(FollowerLink::close);
  }
}
