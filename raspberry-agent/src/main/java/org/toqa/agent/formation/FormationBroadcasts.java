package org.toqa.agent.formation;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.ServerMessage.Lead;

/**
 * What a robot sends to followers: the broadcast of the formation that it leads now, and those of
 * formations that have ended and of whose end not every follower knows yet. Times are nanoseconds
 * on the daemon's monotonic clock. For one thread.
 */
public final class FormationBroadcasts implements AutoCloseable {

  private final String robot;
  private final FollowerConnector connector;
  private final List<FormationBroadcast> ending = new ArrayList<>();
  private @Nullable FormationBroadcast current;

  /**
   * @param robot the name of the leader
   */
  public FormationBroadcasts(String robot, FollowerConnector connector) {
    this.robot = robot;
    this.connector = connector;
  }

  /** Whether nothing is sent to anyone. */
  public boolean isEmpty() {
    return current == null && ending.isEmpty();
  }

  /** What the followers of the formation have answered since the last call. */
  public List<FollowerLink.Answer> takeAnswers() {
    return current == null ? List.of() : current.takeAnswers();
  }

  /**
   * Begins and ends broadcasts.
   *
   * @param order what the robot leads now; empty where it is no leader
   * @param done the last phase that it has driven to its end
   */
  public void update(Optional<Lead> order, Optional<PhaseEnd> done, long nanos) {
    if (current != null && order.filter(current.order()::equals).isEmpty()) {
      end(current, done, nanos);
      current = null;
    }
    if (current == null && order.isPresent()) {
      current = new FormationBroadcast(robot, order.get(), connector, nanos);
    }
  }

  /** Without an end where it is not at its goal: its followers stop, and ask their server. */
  private void end(FormationBroadcast over, Optional<PhaseEnd> done, long nanos) {
    boolean isAtGoal =
        done.filter(end -> end.phase() == 2 && Objects.equals(end.task(), over.order().task()))
            .isPresent();
    if (isAtGoal) {
      over.beginEnd(nanos);
      ending.add(over);
    } else {
      over.close();
    }
  }

  /**
   * Sends what is due: where the leader is, and the ends of formations.
   *
   * @param pose map frame
   * @param twist how the leader is about to move, in its own frame
   * @param braking whether the leader stops for a follower's sake and still moves
   * @param stamp milliseconds since 1970
   */
  public void send(Pose pose, Twist twist, boolean braking, long stamp, long nanos) {
    if (current != null) {
      current.sendPose(pose, twist, braking, stamp, nanos);
    }
    ending.forEach(over -> over.sendEnd(nanos));
    ending.stream().filter(over -> over.isOver(nanos)).forEach(FormationBroadcast::close);
    ending.removeIf(over -> over.isOver(nanos));
  }

  @Override
  public void close() {
    if (current != null) {
      current.close();
    }
    ending.forEach(FormationBroadcast::close);
  }
}
