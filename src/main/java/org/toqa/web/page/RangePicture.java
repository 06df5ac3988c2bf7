package org.toqa.web.page;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * What range sensors measure, as sectors of an SVG picture with the robot at (0, 0) that faces up.
 * Robots do not tell where their sensors look: the sectors are side by side, from right to left.
 */
public final class RangePicture {
  /** Of the robot in the picture. */
  public static final int ROBOT_RADIUS = 20;

  /** From the robot's rim to the sensors' largest range. */
  private static final double REACH = 80;

  /** Radians that a sector is wide at most; all of them make half a circle at most. */
  private static final double WIDEST = Math.toRadians(40);

  private RangePicture() {}

  /**
   * @param path of an SVG path, in its own syntax
   * @param isBlocked whether the sensor sees something
   */
  public record Sector(String path, boolean isBlocked) {}

  /**
   * @param ranges metres, from right to left
   * @param farthest metres, of a sensor that sees nothing
   */
  static List<Sector> of(List<Double> ranges, double farthest) {
    double width = Math.min(WIDEST, Math.PI / Math.max(1, ranges.size()));
    return IntStream.range(0, ranges.size())
        .mapToObj(
            i -> {
              double middle = (i - (ranges.size() - 1) / 2.0) * width; // counter-clockwise from up
              return sector(middle - width / 2, middle + width / 2, ranges.get(i), farthest);
            })
        .toList();
  }

  private static Sector sector(double right, double left, double range, double farthest) {
    double share = farthest > 0 ? Math.min(1, range / farthest) : 1;
    double radius = ROBOT_RADIUS + REACH * share;
    String path =
        "M%s L%s A%s %s 0 0 0 %s L%s A%s %s 0 0 1 %s Z"
            .formatted(
                point(right, ROBOT_RADIUS),
                point(right, radius),
                number(radius),
                number(radius),
                point(left, radius),
                point(left, ROBOT_RADIUS),
                ROBOT_RADIUS,
                ROBOT_RADIUS,
                point(right, ROBOT_RADIUS));
    return new Sector(path, range < farthest);
  }

  private static String point(double angle, double radius) {
    return number(-radius * Math.sin(angle)) + "," + number(-radius * Math.cos(angle));
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.1f", value);
  }
}
