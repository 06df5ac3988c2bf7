package org.toqa.app.bench;

import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/** A simulated body, tick by tick: its pose by odometry, and its true pose. */
final class SimulatedBody implements AutoCloseable {
  /** Seconds between two control steps. */
  static final double TICK = Chassis.TICK.toNanos() / 1e9;

  private final Pose start;
  private final SimulatedChassis body;
  private Twist command = Twist.ZERO;
  private Pose pose;
  private Twist twist = Twist.ZERO;
  private boolean isStanding = true;
  private long nanos;

  /**
   * @param start map frame
   * @param seed of slip and wheel sizes
   */
  SimulatedBody(Pose start, SimulatedWheels wheels, long seed) {
    this.start = start;
    this.pose = start;
    body = new SimulatedChassis(start, wheels, seed);
  }

  /** Lets one tick pass. */
  void advance() {
    ChassisReading reading = body.exchange(command, nanos);
    nanos += Chassis.TICK.toNanos();
    pose = start.compose(reading.odometry());
    twist = reading.twist();
    isStanding = reading.isStanding();
  }

  /**
   * @param twist wanted from now on, robot frame
   */
  void setCommand(Twist twist) {
    command = twist;
  }

  /** How it moves, as its encoders tell, robot frame. */
  Twist twist() {
    return twist;
  }

  /** Whether it stands, within what its encoders can tell. */
  boolean isStanding() {
    return isStanding;
  }

  /** The pose by odometry, map frame. */
  Pose pose() {
    return pose;
  }

  /** The pose that the body really has, map frame. */
  Pose truePose() {
    return body.truePose();
  }

  @Override
  public void close() {
    body.close();
  }
}
