package org.toqa.avoidance.fouragents;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.geometry.Pose;

/**
 * Eight range sensors on the rim of a round robot, in the order of the Khepera II: from the left
 * over the front to the right, then the two behind. Six look ahead and aside; the exact angles are
 * of its manual's drawing, since the seed's figure is lost.
 *
 * @param radius of the robot, metres
 * @param farthest metres from the rim; the reading of a sensor that sees nothing
 */
public record RangeRing(double radius, double farthest) {

  /** Radians from the heading, counter-clockwise. */
  static final List<Double> DIRECTIONS =
      List.of(
          Math.toRadians(90),
          Math.toRadians(45),
          Math.toRadians(10),
          Math.toRadians(-10),
          Math.toRadians(-45),
          Math.toRadians(-90),
          Math.toRadians(-160),
          Math.toRadians(160));

  /** Radians that a sensor sees to either side of where it looks. */
  private static final double CONE = Math.toRadians(10);

  /** How many sensors there are. */
  public static final int SIZE = DIRECTIONS.size();

  /** The sensors' places in {@link #beams}, from right behind over the front to left behind. */
  private static final List<Integer> RIGHT_TO_LEFT =
      IntStream.range(0, SIZE).boxed().sorted(Comparator.comparing(DIRECTIONS::get)).toList();

  /** The same sensors from right behind over the front to left behind, robot frame. */
  public List<Pose> beamsRightToLeft() {
    List<Pose> beams = beams();
    return RIGHT_TO_LEFT.stream().map(beams::get).toList();
  }

  /**
   * Readings in the order of {@link #beams}.
   *
   * @param ranges one a sensor, from right behind over the front to left behind
   */
  public static List<Double> ordered(List<Double> ranges) {
    return IntStream.range(0, SIZE).mapToObj(i -> ranges.get(RIGHT_TO_LEFT.indexOf(i))).toList();
  }

  /** Where each sensor is and looks, robot frame. */
  public List<Pose> beams() {
    return DIRECTIONS.stream()
        .map(d -> new Pose(radius * Math.cos(d), radius * Math.sin(d), d))
        .toList();
  }

  /** The rays of a sensor's cone: to one side, in its middle, to the other side. */
  public static List<Pose> rays(Pose beam) {
    return List.of(beam.compose(new Pose(0, 0, -CONE)), beam, beam.compose(new Pose(0, 0, CONE)));
  }
}
