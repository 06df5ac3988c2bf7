package org.toqa.arm;

/**
 * How the joints of an arm turn from one stand to another: both begin and end together, on the
 * straight line between the two stands, as fast as the slower one may.
 *
 * <p>The share s of the line that is behind them grows with a trapezoid of its rate: it speeds up
 * evenly, goes on evenly, and slows down evenly. Its greatest rate and acceleration are the least
 * of what the joints allow, divided by how far each turns; the limits of angles hold, since they
 * are a box and the line is in it (Siciliano and others, Robotics, 2009, sections 4.2 and 4.3).
 *
 * @param from radians; of both joints
 * @param change radians from begin to end
 * @param startRate shares of the line a second, at the begin
 * @param maxRate shares a second
 * @param maxAcceleration shares a second squared; 0: they stand already
 */
public record JointTrajectory(
    JointAngles from,
    JointAngles change,
    double startRate,
    double maxRate,
    double maxAcceleration) {

  /**
   * Where the joints are at one moment.
   *
   * @param angles radians
   * @param rates radians a second
   */
  public record Moment(JointAngles angles, JointAngles rates) {}

  /** From one stand to another, both of them allowed. */
  public static JointTrajectory between(Arm arm, JointAngles from, JointAngles to) {
    JointAngles change = to.minus(from);
    if (change.largest() < JointLimits.SAME_ANGLE) {
      return standing(to);
    }
    return new JointTrajectory(
        from,
        change,
        0,
        least(
            arm.shoulder().maxRate() / Math.abs(change.shoulder()),
            arm.elbow().maxRate() / Math.abs(change.elbow())),
        least(
            arm.shoulder().maxAcceleration() / Math.abs(change.shoulder()),
            arm.elbow().maxAcceleration() / Math.abs(change.elbow())));
  }

  /** That does not move. */
  public static JointTrajectory standing(JointAngles at) {
    return new JointTrajectory(at, JointAngles.ZERO, 0, 0, 0);
  }

  /** A joint that does not turn limits nothing: infinity or, for 0 / 0, no number. */
  private static double least(double one, double other) {
    return Math.min(Double.isNaN(one) ? other : one, Double.isNaN(other) ? one : other);
  }

  /** Seconds from begin to end. */
  public double duration() {
    return maxAcceleration == 0 ? 0 : speedingUp() + cruising() + slowingDown();
  }

  /** How the joints stand at its end, radians. */
  public JointAngles end() {
    return from.plus(change);
  }

  /** The greatest rate that it comes to: shares a second. */
  private double peak() {
    // up from v0 and down to 0 over one whole line: p^2/2a + (p^2 - v0^2)/2a = 1
    return Math.min(maxRate, Math.sqrt(maxAcceleration + startRate * startRate / 2));
  }

  private double speedingUp() {
    return Math.max(0, peak() - startRate) / maxAcceleration;
  }

  private double slowingDown() {
    return Math.max(peak(), startRate) / maxAcceleration;
  }

  private double cruising() {
    double top = Math.max(peak(), startRate);
    double ramps =
        top * top / (2 * maxAcceleration)
            + (top * top - startRate * startRate) / (2 * maxAcceleration);
    return Math.max(0, 1 - ramps) / top;
  }

  /**
   * @param seconds since its begin; before that as at its begin, after its end as at its end
   */
  public Moment at(double seconds) {
    if (seconds >= duration()) {
      return new Moment(end(), JointAngles.ZERO);
    }
    double t = Math.max(0, seconds);
    double up = speedingUp();
    double even = cruising();
    double a = maxAcceleration;
    if (t < up) {
      return moment(startRate * t + a * t * t / 2, startRate + a * t);
    }
    double top = Math.max(peak(), startRate);
    if (t < up + even) {
      return moment((top * top - startRate * startRate) / (2 * a) + top * (t - up), top);
    }
    double left = duration() - t;
    return moment(1 - a * left * left / 2, a * left);
  }

  private Moment moment(double share, double rate) {
    return new Moment(from.plus(change.times(share)), change.times(rate));
  }

  /**
   * To a stand on the same line, as soon as the joints may.
   *
   * @param seconds since the begin
   */
  public JointTrajectory brakedFrom(double seconds) {
    Moment now = at(seconds);
    double size = change.largest();
    double rate = size == 0 ? 0 : now.rates().largest() / size;
    if (rate == 0) {
      return standing(now.angles());
    }
    // v^2 / 2a of the line is left; as shares of that the rate is 2a / v and the same slowing down
    double braking = rate * rate / (2 * maxAcceleration);
    return new JointTrajectory(
        now.angles(),
        change.times(braking),
        rate / braking,
        maxRate / braking,
        maxAcceleration / braking);
  }
}
