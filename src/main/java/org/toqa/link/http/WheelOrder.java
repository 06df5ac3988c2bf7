package org.toqa.link.http;

import org.jspecify.annotations.Nullable;
import org.toqa.motion.WheelCommand;

/**
 * What both wheels shall do until the next order, or until 200 ms are over without one.
 *
 * @param seq rises; one that is not higher than the last has no effect
 * @param after the stamp of the last answer that was there when it was sent, by the robot's own
 *     clock; null: it has no age, as the first one
 */
public record WheelOrder(long seq, @Nullable Long after, Wheel left, Wheel right) {
  /**
   * Milliseconds that an order's {@code after} may be behind the robot's clock. An answer may be
   * 200 ms on its way and wait 66 ms for the order after it, which has 134 ms for its own way.
   */
  public static final long LONGEST_AGE = 400;

  /**
   * For one wheel, in the words of CSM-MAMRS.
   *
   * @param speed metres a second, positive forward
   * @param amplitude of the pulses (ISPA), 0 to 255: 255 at the robot's largest speed
   * @param pulse milliseconds, 0 to 33
   * @param forward the direction that goes with the amplitude
   */
  public record Wheel(double speed, int amplitude, double pulse, boolean forward) {
    static Wheel of(WheelCommand.Wheel wheel) {
      return new Wheel(
          wheel.speed(), wheel.amplitude(), wheel.pulseMilliseconds(), wheel.isForward());
    }
  }

  /** One without an age, which may come whenever it will: for robots to stand. */
  public static WheelOrder of(long seq, WheelCommand command) {
    return of(seq, null, command);
  }

  public static WheelOrder of(long seq, @Nullable Long after, WheelCommand command) {
    return new WheelOrder(seq, after, Wheel.of(command.left()), Wheel.of(command.right()));
  }

  /**
   * Whether it was held up on its way, or is of a clock that has begun anew since.
   *
   * @param clock milliseconds, by which answers are stamped
   */
  public boolean isStale(long clock) {
    return after != null && (after > clock || clock - after > LONGEST_AGE);
  }
}
