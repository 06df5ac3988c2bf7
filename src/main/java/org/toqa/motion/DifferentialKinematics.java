package org.toqa.motion;

import org.toqa.geometry.Twist;

/**
 * Two driven wheels on one axle, left and right; such a robot cannot go sideways.
 *
 * @param wheelRadius r, metres
 * @param track b, metres between the wheels
 */
public record DifferentialKinematics(double wheelRadius, double track) implements WheelKinematics {

  /**
   * @throws IllegalArgumentException if a length is not positive and finite
   */
  public DifferentialKinematics {
    WheelKinematics.requireLength("wheel radius", wheelRadius);
    WheelKinematics.requireLength("track", track);
  }

  @Override
  public int wheelCount() {
    return 2;
  }

  /**
   * @throws IllegalArgumentException if the twist goes sideways
   */
  // v_left = vx - w b/2,  v_right = vx + w b/2,  wheel speed = v / r
  @Override
  public WheelSpeeds speeds(Twist twist) {
    if (twist.vy() != 0) {
      throw new IllegalArgumentException(
          "Two wheels on one axle cannot go sideways at " + twist.vy() + " m/s.");
    }
    double turning = twist.w() * track / 2;
    return new WheelSpeeds(
        (twist.vx() - turning) / wheelRadius, (twist.vx() + turning) / wheelRadius, 0);
  }

  @Override
  public Twist twist(WheelSpeeds speeds) {
    double left = speeds.first() * wheelRadius;
    double right = speeds.second() * wheelRadius;
    return new Twist((left + right) / 2, 0, (right - left) / track);
  }
}
