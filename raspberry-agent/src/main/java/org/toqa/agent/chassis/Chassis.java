package org.toqa.agent.chassis;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * A robot's body: wheels, odometry, battery and range sensors. The body is apart from the daemon:
 * its odometry counts on while no daemon runs, and it stops its wheels by itself, and drops the
 * path that it drives, when it got no command for {@link #COMMAND_LIFE_NANOS}.
 *
 * <p>The conversation: the daemon calls {@link #exchange} at every tick, always from the same
 * thread; the answer is the body as it is now, at the end of what the previous command did.
 */
public interface Chassis extends AutoCloseable {
  /** How often the daemon asks and commands, if the body does not say otherwise. */
  Duration TICK = Duration.ofMillis(20);

  /** A command older than this stops the wheels. */
  long COMMAND_LIFE_NANOS = 200_000_000;

  /** How many segments of a path the body has at once, at most. */
  int QUEUE_LENGTH = 16;

  /** How often the daemon asks and commands this one, while it does not stand. */
  default Duration period() {
    return TICK;
  }

  /**
   * @param command what to do from now on
   * @param nanos the daemon's monotonic time; a simulated body simulates up to it
   */
  ChassisReading exchange(ChassisCommand command, long nanos);

  /**
   * The same with a velocity.
   *
   * @param velocity wanted from now on, in the robot's frame
   */
  default ChassisReading exchange(Twist velocity, long nanos) {
    return exchange(new MoveAt(velocity), nanos);
  }

  /**
   * Tells the body what is on board from now on; from the thread of {@link #exchange}.
   *
   * @param kilograms 0 for nothing
   */
  default void setLoad(double kilograms) {}

  /**
   * Tells a body that is simulated what lies on it and on others together; as {@link #setLoad}.
   *
   * @param load null: none
   */
  default void setSharedLoad(@Nullable SharedLoad load) {}

  /**
   * Tells a body that measures the map where it is; as {@link #setLoad}.
   *
   * @param anchor the map's pose of the origin of its odometry; null: nobody knows
   */
  default void setAnchor(@Nullable Pose anchor) {}

  /** Its arm; empty where it has none. It is closed with the body. */
  default Optional<ArmDrive> arm() {
    return Optional.empty();
  }

  /**
   * A person says that these stops are over; those whose cause has gone are cleared. From the
   * thread of {@link #exchange}.
   *
   * @param reasons codes of faults that are clearable
   */
  default void clearStops(Set<String> reasons) {}

  @Override
  void close();
}
