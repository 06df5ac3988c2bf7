package org.toqa.agent.chassis;

import org.toqa.arm.ArmCommand;
import org.toqa.arm.ArmReading;

/**
 * The arm on a body. It stands by itself when it got no command for {@link
 * Chassis#COMMAND_LIFE_NANOS}, and what is in its hand stays there. From the thread of {@link
 * Chassis#exchange}, after that.
 */
public interface ArmDrive extends AutoCloseable {

  /** The arm as it was at the last exchange. */
  ArmReading reading();

  /**
   * @param command how it shall be at this moment
   * @param nanos the daemon's monotonic time; a simulated arm moves up to it
   */
  ArmReading exchange(ArmCommand command, long nanos);

  /**
   * Tells an arm that is simulated what the load that it will grasp weighs, as was ordered.
   *
   * @param kilograms 0 or more
   */
  default void expectLoad(double kilograms) {}

  @Override
  void close();
}
