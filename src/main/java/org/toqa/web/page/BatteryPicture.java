package org.toqa.web.page;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.toqa.fleet.history.BatteryLevel;

/**
 * How full a battery was, as the line of an SVG picture of {@link #WIDTH} x {@link #HEIGHT}: time
 * runs to the right, a full battery is at the top.
 *
 * @param points of an SVG polyline, in its own syntax
 */
public record BatteryPicture(String points) {
  public static final int WIDTH = 400;
  public static final int HEIGHT = 100;

  /**
   * @param levels oldest first; between two of them the battery changed evenly
   * @param until what the last one is drawn to
   */
  static BatteryPicture of(List<BatteryLevel> levels, Instant from, Instant until) {
    List<String> points = new ArrayList<>();
    double span = Duration.between(from, until).toMillis();
    for (BatteryLevel level : levels) {
      double x = WIDTH * Duration.between(from, level.at()).toMillis() / span;
      points.add(point(Math.clamp(x, 0, WIDTH), level));
    }
    if (!levels.isEmpty()) {
      points.add(point(WIDTH, levels.getLast()));
    }
    return new BatteryPicture(String.join(" ", points));
  }

  public boolean isEmpty() {
    return points.isEmpty();
  }

  private static String point(double x, BatteryLevel level) {
    return String.format(Locale.ROOT, "%.1f,%.1f", x, HEIGHT * (1 - level.level()));
  }
}
