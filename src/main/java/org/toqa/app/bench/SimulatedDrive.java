package org.toqa.app.bench;

import org.toqa.agent.Daemon;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/** A simulated body, tick by tick: where it takes itself to be, and where it is. */
final class SimulatedDrive implements AutoCloseable {
  static final double TICK = Daemon.TICK.toNanos() / 1e9;

  private final Pose start;
  private final SimulatedChassis body;
  private Twist command = Twist.ZERO;
  private Pose pose;
  private long nanos;

  SimulatedDrive(Pose start, SimulatedWheels wheels, long seed) {
    this.start = start;
    this.pose = start;
    body = new SimulatedChassis(start, wheels, seed);
  }

  /** Lets one tick pass. */
  void live() {
    ChassisReading reading = body.exchange(command, nanos);
    nanos += Daemon.TICK.toNanos();
    pose = start.compose(reading.odometry());
  }

  /**
   * @param twist wanted from now on, robot frame
   */
  void command(Twist twist) {
    command = twist;
  }

  /** By odometry, map frame. */
  Pose pose() {
    return pose;
  }

  /** Map frame. */
  Pose truth() {
    return body.truth();
  }

  @Override
  public void close() {
    body.close();
  }
}
