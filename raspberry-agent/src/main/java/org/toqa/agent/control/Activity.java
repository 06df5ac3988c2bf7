package org.toqa.agent.control;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Role;

/**
 * What a robot does now, exactly one at a time; each activity owns what belongs to it. For the
 * thread of the ticks.
 */
sealed interface Activity permits Alone, Leading, Following {

  /**
   * One tick of the control.
   *
   * @param reading of the body
   * @param pose where the robot is, map frame
   * @param seconds since the last tick
   * @param now seconds on the daemon's monotonic clock
   * @param canMove false: held, or its body has a fault
   */
  record Tick(ChassisReading reading, Pose pose, double seconds, double now, boolean canMove) {}

  Role role();

  /** What the robot carries together with others. */
  Optional<SharedLoad> sharedLoad();

  /** The current drive; a follower has none. */
  Optional<DriveRun> drive();

  /**
   * Moves what this activity drives by on by one tick.
   *
   * @return what to command the body
   */
  ChassisCommand steer(Tick tick);

  /**
   * Whether the phase is over by the robot's own motion; a follower's phase ends by its leader's
   * message. To be asked at every tick of a drive that is not cancelled.
   *
   * @param now seconds on the daemon's monotonic clock
   */
  boolean isPhaseOver(double now);

  /**
   * What is wrong with the formation, if this is a part of one.
   *
   * @param now seconds on the daemon's monotonic clock
   */
  Optional<Fault> fault(double now);

  /**
   * What is left of it when the robot shall not work for the task any more. A drive goes on until
   * it is cancelled itself.
   *
   * @param task null: drives without a task
   */
  Activity cancel(@Nullable Long task);

  /** The same after its drive has come to a standstill. */
  Activity withoutDrive();
}
