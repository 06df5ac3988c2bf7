package org.toqa.link.http;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.motion.DifferentialKinematics;

/**
 * What a robot says of its body. The limits are those of {@code docs/http-robot.md}.
 *
 * @param track metres between its two wheels, 0.02 to 5
 * @param wheelRadius metres, 0.005 to 1
 * @param countsPerTurn counts of an encoder for one turn of its wheel, 1 to 10,000,000
 * @param maxSpeed metres a second of either wheel, 0.01 to 5
 * @param maxLoad kilograms, 0 to 10,000
 * @param footprint diameter in metres, 0.05 to 5
 * @param hasRangeSensors whether each report has ranges
 * @param rangeAngles where the sensors of these look, from their places on its rim: radians,
 *     counter-clockwise from straight ahead, from right to left; empty: the usual three
 * @param sonar null: its place is not corrected by ranges
 * @param boot another number whenever the counts have begun anew
 * @param seq of the last command that it obeyed; 0 for none
 */
public record RobotDescription(
    double track,
    double wheelRadius,
    int countsPerTurn,
    double maxSpeed,
    double maxLoad,
    double footprint,
    boolean hasRangeSensors,
    List<Double> rangeAngles,
    @Nullable Sonar sonar,
    long boot,
    long seq) {

  /**
   * Ultrasonic sensors on its rim, whose ranges it publishes by MQTT with their angles, and by
   * which its place shall be corrected.
   *
   * @param farthest metres: what is told as this, or as more, is nothing; 0.1 to 30
   * @param deviation standard deviation of a range on the floor from that on the map, metres, 0.001
   *     to 0.5
   */
  public record Sonar(double farthest, double deviation) {}

  public RobotDescription {
    rangeAngles = List.copyOf(rangeAngles);
  }

  /** The version of the commands and reports here. */
  public static final int VERSION = 1;

  public DifferentialKinematics kinematics() {
    return new DifferentialKinematics(wheelRadius, track);
  }

  /** Metres that a wheel rolls for one count. */
  public double metresPerCount() {
    return 2 * Math.PI * wheelRadius / countsPerTurn;
  }
}
