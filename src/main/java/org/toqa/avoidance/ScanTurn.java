package org.toqa.avoidance;

import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/**
 * A robot that is stopped before something turns left and right to see how wide it is, again and
 * again: its beams are thin and look ahead.
 */
public final class ScanTurn {

  private static final double WIDEST = Math.toRadians(50);

  /** Radians a second: once left and right takes 3.5 s. */
  private static final double TURN_RATE = 1;

  private double heading;
  private double rate;
  private double side = WIDEST;

  /**
   * Lets time go on.
   *
   * @param isScanning whether it shall look round; else it turns back
   * @param seconds since the last step, at least 0
   */
  public void step(boolean isScanning, double seconds) {
    double target = isScanning ? side : 0;
    double most = TURN_RATE * seconds;
    double next = heading + Math.clamp(target - heading, -most, most);
    if (isScanning && next == target) {
      side = -side;
    }
    rate = seconds > 0 ? (next - heading) / seconds : 0;
    heading = next;
  }

  /** It stays turned as it is. */
  public void hold() {
    rate = 0;
  }

  /** Whether the robot faces as its path says. */
  public boolean isStraight() {
    return heading == 0 && rate == 0;
  }

  /**
   * The heading that the stopped robot shall have.
   *
   * @param straight how it would, in any frame
   */
  public Pose turned(Pose straight) {
    return heading == 0 ? straight : straight.compose(new Pose(0, 0, heading));
  }

  /**
   * How the robot shall move, in its own frame.
   *
   * @param straight how it would, in its own frame; zero while it is not straight
   */
  public Twist turned(Twist straight) {
    return rate == 0 ? straight : new Twist(straight.vx(), straight.vy(), straight.w() + rate);
  }
}
