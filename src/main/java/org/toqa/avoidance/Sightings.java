package org.toqa.avoidance;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * What was seen a short while ago: a thin beam passes a thing at the edge of the corridor long
 * before the robot does.
 */
public final class Sightings {

  /**
   * Seconds: at 0.25 m/s a robot has passed what it saw 0.8 m ahead, and one that stands has looked
   * round once more (see {@link Glance}).
   */
  public static final double REMEMBERED = 4.5;

  /** Metres; points so near to each other are one. */
  private static final double SAME = 0.03;

  private final List<Sighting> sightings = new ArrayList<>();

  private record Sighting(Vec2 point, double seconds) {
    boolean isSame(Vec2 other) {
      return point.distanceTo(other) < SAME;
    }
  }

  /**
   * @param points map frame
   * @param seconds on a monotonic clock
   */
  public void remember(Collection<Vec2> points, double seconds) {
    for (Vec2 point : points) {
      boolean isKnown = sightings.stream().anyMatch(old -> old.isSame(point));
      sightings.replaceAll(old -> old.isSame(point) ? new Sighting(old.point, seconds) : old);
      if (!isKnown) {
        sightings.add(new Sighting(point, seconds));
      }
    }
  }

  /** Drops what was not seen for long. */
  public void forget(double seconds) {
    sightings.removeIf(old -> seconds - old.seconds > REMEMBERED);
  }

  /** Map frame. */
  public List<Vec2> points() {
    return sightings.stream().map(Sighting::point).toList();
  }
}
