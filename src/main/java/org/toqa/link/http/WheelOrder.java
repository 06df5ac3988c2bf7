package org.toqa.link.http;

import org.toqa.motion.WheelCommand;

/**
 * What both wheels shall do until the next order, or until 200 ms are over without one.
 *
 * @param seq rises; one that is not higher than the last has no effect
 */
public record WheelOrder(long seq, Wheel left, Wheel right) {

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

  public static WheelOrder of(long seq, WheelCommand command) {
    return new WheelOrder(seq, Wheel.of(command.left()), Wheel.of(command.right()));
  }
}
