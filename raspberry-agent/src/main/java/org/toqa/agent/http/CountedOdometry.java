package org.toqa.agent.http;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.storage.NumberFile;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.WheelReport;
import org.toqa.motion.Odometry;
import org.toqa.motion.WheelSpeeds;

/**
 * The odometry of a robot that tells nothing but counts. It is kept in a file, and goes on with
 * what the wheels have turned while no daemon ran: a robot that was told nothing has come no
 * farther than it takes to stop. Counts that have jumped by more say nothing of where the robot is,
 * nor do those that have begun anew: then odometry begins anew, as after a power-up. For one
 * thread.
 */
final class CountedOdometry implements AutoCloseable {
  private static final int NUMBERS = 7;
  private static final Pose ORIGIN = new Pose(0, 0, 0);

  /** Wheels may turn faster than was said by this factor before they are not believed. */
  private static final double FASTER = 1.5;

  /** Metres, for counters that are read a little before the answer. */
  private static final double SLACK = 0.02;

  /** Seconds in which a robot that is told nothing more has stopped, from full speed. */
  private static final double STOPPED_AFTER = 0.6;

  /** The stamps of the robot's own clock are used where they are about right. */
  private static final double MOST_CLOCK_ERROR = 4;

  private final NumberFile file;
  private final RobotDescription body;
  private Odometry odometry;
  private long epoch;
  private long boot;
  private int[] counts = {0, 0};
  private Twist twist = Twist.ZERO;
  private @Nullable WheelReport last;
  private long lastAsked;
  private long lastAnswered;

  /** After which it was told nothing more. */
  private long lastOrdered;

  /** What a report has shown of the counts. */
  enum Outcome {
    CONTINUED,
    BEGUN_ANEW,
    JUMPED
  }

  /** Goes on from the file, or begins. */
  CountedOdometry(Path file, RobotDescription body) throws IOException {
    this.file = new NumberFile(file, NUMBERS);
    this.body = body;
    Optional<double[]> kept = this.file.read();
    Pose pose = ORIGIN;
    if (kept.isPresent()) {
      double[] n = kept.get();
      epoch = (long) n[0];
      boot = (long) n[1];
      pose = new Pose(n[2], n[3], n[4]);
      counts = new int[] {(int) n[5], (int) n[6]};
    }
    odometry = odometryAt(pose);
  }

  private Odometry odometryAt(Pose pose) {
    return new Odometry(body.kinematics(), body.countsPerTurn(), pose, counts);
  }

  /**
   * The counts were read at some time between question and answer, which are on a monotonic clock
   * and far apart where network or machine were busy.
   *
   * @param asked when it was asked for
   * @param answered when it came
   */
  Outcome update(WheelReport report, long asked, long answered) {
    int[] now = {(int) report.left(), (int) report.right()}; // as counters wrap around
    double seconds = last == null ? STOPPED_AFTER : (answered - lastAnswered) / 1e9;
    double atMost =
        last == null
            ? STOPPED_AFTER
            : Math.min(
                (answered - lastAsked) / 1e9, (lastOrdered - lastAsked) / 1e9 + STOPPED_AFTER);
    Outcome outcome = outcome(report, now, atMost);
    if (outcome == Outcome.CONTINUED) {
      twist = last == null ? Twist.ZERO : twist(report, last, now, seconds);
      odometry.update(now);
      counts = now;
    } else {
      boot = report.boot();
      counts = now;
      beginAnew();
    }
    last = report;
    lastAsked = asked;
    lastAnswered = answered;
    lastOrdered = asked;
    Pose pose = odometry.pose();
    file.write(
        (double) epoch, (double) boot, pose.x(), pose.y(), pose.theta(), counts[0], counts[1]);
    return outcome;
  }

  /**
   * An order had no answer; it may have been obeyed.
   *
   * @param givenUp when it was
   */
  void miss(long givenUp) {
    lastOrdered = givenUp;
  }

  private Outcome outcome(WheelReport report, int[] now, double seconds) {
    if (epoch == 0 || report.boot() != boot) {
      return Outcome.BEGUN_ANEW;
    }
    double farthest = FASTER * body.maxSpeed() * seconds + SLACK;
    return isWithin(farthest, now[0] - counts[0]) && isWithin(farthest, now[1] - counts[1])
        ? Outcome.CONTINUED
        : Outcome.JUMPED;
  }

  private boolean isWithin(double metres, int counted) {
    return Math.abs((double) counted) * body.metresPerCount() <= metres;
  }

  private Twist twist(WheelReport report, WheelReport before, int[] now, double seconds) {
    double stamped = (report.stamp() - before.stamp()) / 1e3;
    boolean isAboutRight =
        stamped > seconds / MOST_CLOCK_ERROR && stamped < seconds * MOST_CLOCK_ERROR;
    double dt = isAboutRight ? stamped : seconds;
    if (dt <= 0) {
      return twist;
    }
    return body.kinematics()
        .twist(
            WheelSpeeds.of(
                now.length,
                wheel -> (now[wheel] - counts[wheel]) * 2 * Math.PI / body.countsPerTurn() / dt));
  }

  /** Moved since the odometry began, in the frame of the pose that the robot had then. */
  Pose pose() {
    return odometry.pose();
  }

  /** From here on it is counted from another origin: nobody knows where the former one is. */
  void beginAnew() {
    epoch++;
    twist = Twist.ZERO;
    odometry = odometryAt(ORIGIN);
  }

  /** Corrects that. */
  void setPose(Pose pose) {
    odometry.setPose(pose);
  }

  /** In the robot's frame. */
  Twist twist() {
    return twist;
  }

  /** Another number whenever odometry has begun anew, from 1. */
  long epoch() {
    return epoch;
  }

  @Override
  public void close() {
    file.close();
  }
}
