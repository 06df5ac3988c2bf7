package org.toqa.formation;

import java.util.SplittableRandom;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/**
 * One follower behind a leader that drives an arc and tells so every 0.2 s over a link with delay.
 * The follower's body obeys with a lag of 0.06 s and errs by 1 % of its speed.
 */
final class FollowerTrial {

  static final double TICK = 0.02;

  private static final double LAG = 0.06;
  private static final double NOISE = 0.01;
  private static final int TICKS_A_MESSAGE = 10;
  private static final double USUAL_DELAY = 0.02;

  private final Follower follower;
  private final Vec2 offset;
  private final int delayTicks;
  private final SplittableRandom random;

  FollowerTrial(FollowerLaw law, Vec2 offset, double tolerance, int delayTicks, long seed) {
    this.follower = new Follower(law, offset, tolerance, USUAL_DELAY);
    this.offset = offset;
    this.delayTicks = delayTicks;
    this.random = new SplittableRandom(seed);
  }

  Follower follower() {
    return follower;
  }

  /**
   * @param startError metres that it is beside its place at first
   * @return its largest distance from its place after {@code settling} seconds
   */
  double worstError(Pose start, Twist leader, double startError, double settling, double seconds) {
    Twist place = RigidMotion.at(offset, leader);
    double course = Math.atan2(place.vy(), place.vx());
    Pose body = placeOf(start).compose(new Pose(0, startError, course));
    if (follower.trouble().isEmpty()) {
      throw new IllegalStateException("a trial is run once");
    }
    Twist speed = Twist.ZERO;
    double worst = 0;
    for (int i = 0; i * TICK < seconds; i++) {
      double now = i * TICK;
      int sent = i - delayTicks;
      if (sent >= 0 && sent % TICKS_A_MESSAGE == 0) {
        follower.receive(start.advanced(leader, sent * TICK), leader, now);
      }
      speed = lagging(speed, follower.steer(body, now));
      body = body.advanced(noisy(speed), TICK);
      if (now > settling) {
        Pose truePlace = placeOf(start.advanced(leader, now + TICK));
        worst = Math.max(worst, truePlace.distanceTo(body));
      }
    }
    return worst;
  }

  private Pose placeOf(Pose leader) {
    return leader.compose(new Pose(offset.x(), offset.y(), 0));
  }

  private static Twist lagging(Twist speed, Twist wanted) {
    double share = 1 - Math.exp(-TICK / LAG);
    return new Twist(
        speed.vx() + share * (wanted.vx() - speed.vx()),
        speed.vy() + share * (wanted.vy() - speed.vy()),
        speed.w() + share * (wanted.w() - speed.w()));
  }

  private Twist noisy(Twist speed) {
    return new Twist(err(speed.vx()), err(speed.vy()), err(speed.w()));
  }

  private double err(double value) {
    return value * (1 + NOISE * random.nextGaussian());
  }
}
