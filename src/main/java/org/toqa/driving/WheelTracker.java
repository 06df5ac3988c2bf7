package org.toqa.driving;

import java.util.ArrayList;
import java.util.List;
import org.toqa.formation.FollowerLaw;
import org.toqa.formation.UnicycleLaw;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;

/**
 * Keeps a robot that takes wheel commands on a moving reference, though what it answers is old: the
 * law of Kanayama et al. (ICRA 1990, as {@link UnicycleLaw}) on a pose that is predicted by the
 * commands that the robot has not answered yet (a Smith predictor; O. J. M. Smith, "Closer control
 * of loops with dead time", 1957). Its motors are taken for lags of the first order.
 *
 * <ol>
 *   <li>Every sample of 30 ms, {@link #next} is given the reference at the moment at which the next
 *       command comes into effect, and the newest answer: where the robot was, by its wheel counts,
 *       as one of the commands came into effect.
 *   <li>From there each command since is taken to be driven for a sample; that is where the robot
 *       will be.
 *   <li>The law corrects what that is away from the reference; the wheels' limit holds in any case.
 * </ol>
 *
 * <p>It needs no clock that both sides share: answers are told apart by the number of the command.
 * Confined to one thread.
 */
public final class WheelTracker {
  private static final FollowerLaw LAW = new UnicycleLaw();

  private final DifferentialLimits limits;
  private final double response;

  /** Share of a change of speed that is done after a sample. */
  private final double reached;

  /** Share of it that is missing on average during the sample. */
  private final double missing;

  /** What the robot does in the sample of each command, in its own frame. */
  private final List<Twist> driven = new ArrayList<>();

  /** What it does as the next command comes into effect. */
  private Twist now = Twist.ZERO;

  /**
   * @param response time constant of the robot's motors, seconds, not below 0
   */
  public WheelTracker(DifferentialLimits limits, double response) {
    this.limits = limits;
    this.response = response;
    this.reached = response <= 0 ? 1 : 1 - Math.exp(-WheelCommand.SAMPLE / response);
    this.missing = response / WheelCommand.SAMPLE * reached;
  }

  /** How many commands were made; the next one has this number, from 0. */
  public int sent() {
    return driven.size();
  }

  /**
   * Where the robot will be as the next command comes into effect, map frame.
   *
   * @param answered the number of a command that was made, or the one that is next
   * @param pose where the robot was as that one came into effect
   */
  public Pose predicted(int answered, Pose pose) {
    Pose then = pose;
    for (Twist twist : driven.subList(answered, driven.size())) {
      then = then.advanced(twist, WheelCommand.SAMPLE);
    }
    return then;
  }

  /**
   * The next command.
   *
   * @param reference where the robot should be as the command comes into effect, map frame
   * @param twist the reference's velocity in that sample, in its own frame
   * @param then the same for the sample after it
   * @param answered see {@link #predicted}
   * @param pose see {@link #predicted}
   */
  public WheelCommand next(Pose reference, Twist twist, Twist then, int answered, Pose pose) {
    Twist velocity = LAW.velocity(reference, twist, predicted(answered, pose));
    // a motor that lags by T follows a ramp if it is told v + T dv/dt
    double lead = response / WheelCommand.SAMPLE;
    WheelCommand command =
        WheelCommand.of(
            driven.size() * WheelCommand.SAMPLE,
            velocity.vx() + lead * (then.vx() - twist.vx()),
            velocity.w() + lead * (then.w() - twist.w()),
            limits);
    Twist told = new Twist(command.v(), 0, command.w());
    driven.add(between(told, now, missing));
    now = between(now, told, reached);
    return command;
  }

  private static Twist between(Twist from, Twist to, double share) {
    return new Twist(
        from.vx() + share * (to.vx() - from.vx()), 0, from.w() + share * (to.w() - from.w()));
  }
}
