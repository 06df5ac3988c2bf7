package org.toqa.avoidance;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.Predicate;
import org.toqa.geometry.Vec2;

/**
 * What was seen a short while ago: a thin beam passes a thing at the edge of the corridor long
 * before the robot does.
 */
public final class DetectionMemory {

  /**
   * Seconds: at 0.25 m/s a robot has passed what it saw 0.8 m ahead, and one that is stopped has
   * looked round once more (see {@link ScanTurn}).
   */
  public static final double MEMORY_SECONDS = 4.5;

  /** Metres; points so near to each other are one. */
  private static final double SAME = 0.03;

  private final double same;
  private final List<Detection> detections = new ArrayList<>();

  public DetectionMemory() {
    this(SAME);
  }

  /**
   * @param same metres; points so near to each other are one, which is where it was first seen
   */
  public DetectionMemory(double same) {
    this.same = same;
  }

  /**
   * @param point metres, map frame
   * @param seconds when it was seen last, on a monotonic clock
   */
  private record Detection(Vec2 point, double seconds) {}

  /**
   * Notes what is seen.
   *
   * @param points metres, map frame
   * @param seconds on a monotonic clock
   */
  public void remember(Collection<Vec2> points, double seconds) {
    for (Vec2 point : points) {
      boolean isKnown = detections.stream().anyMatch(old -> isSame(old, point));
      detections.replaceAll(old -> isSame(old, point) ? new Detection(old.point, seconds) : old);
      if (!isKnown) {
        detections.add(new Detection(point, seconds));
      }
    }
  }

  private boolean isSame(Detection old, Vec2 point) {
    return old.point.distanceTo(point) < same;
  }

  /**
   * Drops what was not seen for long.
   *
   * @param seconds now, on the same clock
   */
  public void forgetOld(double seconds) {
    detections.removeIf(old -> seconds - old.seconds > MEMORY_SECONDS);
  }

  /**
   * Drops what is not where it was seen.
   *
   * @param isGone of points, metres, map frame
   */
  public void forget(Predicate<Vec2> isGone) {
    detections.removeIf(old -> isGone.test(old.point));
  }

  /** Whether nothing was seen of late. */
  public boolean isEmpty() {
    return detections.isEmpty();
  }

  /** What was seen, metres, map frame. */
  public List<Vec2> points() {
    return detections.stream().map(Detection::point).toList();
  }
}
