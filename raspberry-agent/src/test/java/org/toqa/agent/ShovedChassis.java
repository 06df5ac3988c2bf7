package org.toqa.agent;

import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/** A body that is shoved aside, and whose odometry tells it. */
final class ShovedChassis implements Chassis {
  private final Chassis body;
  private Vec2 shove = Vec2.ZERO;

  ShovedChassis(Chassis body) {
    this.body = body;
  }

  /**
   * @param by metres, in the frame in which the body began
   */
  void shove(Vec2 by) {
    shove = shove.plus(by);
  }

  @Override
  public ChassisReading exchange(Twist command, long nanos) {
    ChassisReading now = body.exchange(command, nanos);
    Pose at = now.odometry();
    return new ChassisReading(
        now.powerCycle(),
        now.startPose(),
        new Pose(at.x() + shove.x(), at.y() + shove.y(), at.theta()),
        now.twist(),
        now.battery(),
        now.ranges(),
        now.faults());
  }

  @Override
  public void close() {
    body.close();
  }
}
