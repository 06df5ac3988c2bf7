package org.toqa.app.bench;

import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.exact.ShortestDiscPath;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.PlanningBudget;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.SmoothPlanner;
import org.toqa.planning.smooth.SmoothResult;
import org.toqa.planning.smooth.SmoothResult.Found;
import org.toqa.planning.smooth.SmoothResult.NotFound;
import org.toqa.planning.smooth.SmoothResult.Reason;
import org.toqa.planning.smooth.WayPath;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

/** Plans from one place to another on one grid, and knows the exact length. */
final class SmoothRun {
  /** The share of the time that the way points have; the rest is for the curve. */
  private static final double FOR_WAY_POINTS = 0.88;

  private static final Duration WARM_UP = Duration.ofSeconds(4);

  /** Metres. */
  private static final double APART = 0.01;

  /** Of the radius: points of a curve are so near that chords leave it by a millionth of it. */
  private static final double APART_BY_RADIUS = 0.02;

  private final DiscSpace space;
  private final SmoothMethod method;
  private final Vec2 from;
  private final Vec2 to;
  private final OptionalDouble shortest;

  /**
   * @param length metres along the curve
   * @param shortest metres
   * @param maxCurvature radians a metre
   * @param turnsOnSpot where no curve without a stop fits
   * @param path metres, map frame
   * @param progress iteration and length, metres, of each shorter path
   */
  record Report(
      boolean found,
      @Nullable Reason reason,
      @Nullable Double length,
      @Nullable Double shortest,
      @Nullable Double ratio,
      @Nullable Double maxCurvature,
      @Nullable Integer turnsOnSpot,
      double milliseconds,
      List<double[]> path,
      List<double[]> progress) {}

  SmoothRun(OccupancyGrid grid, double radius, SmoothMethod method, Vec2 from, Vec2 to) {
    this.space = DiscSpace.of(grid, radius);
    this.method = method;
    this.from = from;
    this.to = to;
    this.shortest = new ShortestDiscPath(grid, radius).length(from, to);
  }

  /** Whether there is a path at all. */
  boolean isReachable() {
    return shortest.isPresent();
  }

  void warmUp(int limitMs) {
    long begin = System.nanoTime();
    int longest = Math.min(limitMs, (int) WARM_UP.toMillis() / 4);
    for (long seed = 1; System.nanoTime() - begin < WARM_UP.toNanos(); seed++) {
      plan(-seed, longest);
    }
  }

  Report plan(long seed, int limitMs) {
    long begin = System.nanoTime();
    Duration limit = Duration.ofNanos((long) (limitMs * 1e6 * FOR_WAY_POINTS));
    PlanningBudget budget = PlanningBudget.time(limit, System::nanoTime);
    SmoothResult result = new SmoothPlanner(method, seed).plan(space, from, to, budget);
    return switch (result) {
      case Found(WayPath path) -> {
        SmoothCurve curve = new SplineFitter(space).fit(path.points());
        yield found(path, curve, (System.nanoTime() - begin) / 1e6);
      }
      case NotFound(Reason reason) -> notFound(reason, (System.nanoTime() - begin) / 1e6);
    };
  }

  private Report found(WayPath path, SmoothCurve curve, double milliseconds) {
    double length = curve.length();
    List<Vec2> points = curve.points(Math.min(APART, APART_BY_RADIUS * space.radius()));
    @Nullable Double exact = shortest.isPresent() ? (Double) shortest.getAsDouble() : null;
    return new Report(
        true,
        null,
        length,
        exact,
        exact == null ? null : (Double) (exact == 0 ? 1 : length / exact),
        curve.maxCurvature(),
        Math.max(0, curve.pieces().size() - 1),
        milliseconds,
        (points.isEmpty() ? path.points() : points)
            .stream().map(point -> new double[] {point.x(), point.y()}).toList(),
        path.progress().stream()
            .map(shorter -> new double[] {shorter.iteration(), shorter.length()})
            .toList());
  }

  private Report notFound(Reason reason, double milliseconds) {
    @Nullable Double exact = shortest.isPresent() ? (Double) shortest.getAsDouble() : null;
    return new Report(
        false, reason, null, exact, null, null, null, milliseconds, List.of(), List.of());
  }
}
