package org.toqa.fleet;

import java.util.ArrayList;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.motion.Trajectory;

/** The drive of a scripted robot, how far it has come, and the task that it is for. */
final class ScriptedDrive {
  private @Nullable Trajectory trajectory;
  private @Nullable Long task;
  private @Nullable Done done;
  private int phase;
  private long number;
  private int segment;
  private int released;
  private boolean last;

  void start(Drive drive) {
    begin(drive.task(), drive.phase(), drive.seq(), drive.released());
    trajectory = new Trajectory(drive.start(), drive.segments());
    last = drive.last();
  }

  /** It is in phase 2 while it follows, and drives no trajectory of its own. */
  void follow(Follow order) {
    begin(order.task(), 2, order.seq(), 0);
  }

  private void begin(@Nullable Long ofTask, int inPhase, long seq, int releasedSegments) {
    task = ofTask;
    phase = inPhase;
    number = seq;
    segment = 0;
    released = releasedSegments;
    done = null;
  }

  void extend(Extend extension) {
    Trajectory old = Objects.requireNonNull(trajectory);
    var segments = new ArrayList<>(old.segments().subList(0, extension.from()));
    segments.addAll(extension.segments());
    trajectory = new Trajectory(old.start(), segments);
    released = extension.released();
    last = extension.last();
  }

  void release(Release release) {
    released = release.released();
  }

  /** Drives the next released segment; null where there is none. */
  @Nullable Pose nextPose() {
    if (trajectory == null || segment >= released) {
      return null;
    }
    segment++;
    return trajectory.poseAfter(segment);
  }

  boolean isAtGoal() {
    return trajectory != null && last && segment == trajectory.segments().size();
  }

  /** It is at its goal, and says so until the server has heard it. */
  void end() {
    done = new Done(task, phase, number);
    abandon();
  }

  /** There is no drive any more; the task stays. */
  void abandon() {
    trajectory = null;
    number = 0;
  }

  void cancel() {
    abandon();
    task = null;
    done = null;
  }

  void acknowledge(AckDone ack) {
    if (done != null && done.drive() == ack.done()) {
      task = done.phase() == 3 ? null : task;
      done = null;
    }
  }

  boolean hasTrajectory() {
    return trajectory != null;
  }

  @Nullable Long task() {
    return task;
  }

  /** What the server has not acknowledged yet. */
  @Nullable Done done() {
    return done;
  }

  int phase() {
    return phase;
  }

  /** 0 where there is none. */
  long number() {
    return number;
  }

  int segment() {
    return segment;
  }

  int released() {
    return released;
  }
}
