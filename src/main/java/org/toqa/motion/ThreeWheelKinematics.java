package org.toqa.motion;

import org.toqa.geometry.Twist;

/**
 * Three omnidirectional wheels, 120 degrees apart; wheel 2's axle lies on the robot's x axis
 * (Tanta, "Kinematics of the three-wheeled omni robot").
 *
 * @param wheelRadius r, metres
 * @param centreToWheel R, metres
 */
public record ThreeWheelKinematics(double wheelRadius, double centreToWheel)
    implements WheelKinematics {

  /** The sizes that are configured where nobody has measured. */
  public static final ThreeWheelKinematics DEFAULT = new ThreeWheelKinematics(0.04, 0.10);

  private static final double SQRT_3 = Math.sqrt(3);

  /**
   * @throws IllegalArgumentException if a length is not positive and finite
   */
  public ThreeWheelKinematics {
    WheelKinematics.requireLength("wheel radius", wheelRadius);
    WheelKinematics.requireLength("distance from centre to wheel", centreToWheel);
  }

  @Override
  public int wheelCount() {
    return 3;
  }

  // v1 =  sqrt(3)/2 vx - 1/2 vy + R w
  // v2 =                     vy + R w
  // v3 = -sqrt(3)/2 vx - 1/2 vy + R w,   wheel speed = v / r
  @Override
  public WheelSpeeds speeds(Twist twist) {
    double along = SQRT_3 / 2 * twist.vx();
    double turning = centreToWheel * twist.w();
    return new WheelSpeeds(
        (along - twist.vy() / 2 + turning) / wheelRadius,
        (twist.vy() + turning) / wheelRadius,
        (-along - twist.vy() / 2 + turning) / wheelRadius);
  }

  // vx = (v1 - v3)/sqrt(3),  vy = (2 v2 - v1 - v3)/3,  w = (v1 + v2 + v3)/(3 R)
  @Override
  public Twist twist(WheelSpeeds speeds) {
    double v1 = speeds.first() * wheelRadius;
    double v2 = speeds.second() * wheelRadius;
    double v3 = speeds.third() * wheelRadius;
    return new Twist(
        (v1 - v3) / SQRT_3, (2 * v2 - v1 - v3) / 3, (v1 + v2 + v3) / (3 * centreToWheel));
  }
}
