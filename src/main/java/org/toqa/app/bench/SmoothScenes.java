package org.toqa.app.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.statistics.Percentiles;

/** Plans on many random scenes, each laid out anew for each plan. */
final class SmoothScenes {
  private static final Duration WARM_UP = Duration.ofSeconds(4);

  /** Metres by which a disc may overlap a wall: chords of a curve, and rounding. */
  private static final double TOUCHES = 1e-5;

  private final double radius;
  private final SmoothMethod method;
  private final long seed;
  private final List<SmoothScene> scenes;

  /** Of all scenes with one time limit. */
  record Limit(
      int limitMs,
      double medianRatio,
      double p95Ratio,
      double maxRatio,
      int failures,
      int touching,
      double medianMilliseconds,
      double maxMilliseconds) {}

  /**
   * @param reachable scenes in which there is a path
   */
  record Report(int scenes, int reachable, double radius, long seed, List<Limit> limits) {}

  /**
   * @param radius metres
   */
  SmoothScenes(double radius, SmoothMethod method, long seed, int count) {
    this.radius = radius;
    this.method = method;
    this.seed = seed;
    this.scenes =
        IntStream.range(0, count).mapToObj(i -> SmoothScene.random(radius, seed + i)).toList();
  }

  Report measure(List<Integer> limits) {
    warmUp();
    List<Limit> measured = limits.stream().map(this::measure).toList();
    int reachable = (int) scenes.stream().filter(scene -> run(scene).isReachable()).count();
    return new Report(scenes.size(), reachable, radius, seed, measured);
  }

  private void warmUp() {
    long begin = System.nanoTime();
    for (int i = 0; System.nanoTime() - begin < WARM_UP.toNanos(); i++) {
      run(scenes.get(i % scenes.size())).plan(-i, 20);
    }
  }

  private SmoothRun run(SmoothScene scene) {
    return new SmoothRun(scene.grid(), radius, method, scene.from(), scene.to());
  }

  private Limit measure(int limitMs) {
    List<SmoothRun.Report> reports = new ArrayList<>();
    int touching = 0;
    for (SmoothScene scene : scenes) {
      SmoothRun.Report report = run(scene).plan(seed, limitMs);
      reports.add(report);
      touching += touches(scene, report) ? 1 : 0;
    }
    Percentiles ratios =
        new Percentiles(
            reports.stream()
                .map(SmoothRun.Report::ratio)
                .filter(Objects::nonNull)
                .mapToDouble(Double::doubleValue)
                .toArray());
    Percentiles times =
        new Percentiles(reports.stream().mapToDouble(SmoothRun.Report::milliseconds).toArray());
    int failures = (int) reports.stream().filter(r -> r.found() != (r.shortest() != null)).count();
    return new Limit(
        limitMs,
        ratios.percentile(0.5),
        ratios.percentile(0.95),
        ratios.max(),
        failures,
        touching,
        times.percentile(0.5),
        times.max());
  }

  /** Looks at the path's lines by the cells that a disc along them touches. */
  private boolean touches(SmoothScene scene, SmoothRun.Report report) {
    Disc disc = new Disc(radius - TOUCHES);
    List<Vec2> path = report.path().stream().map(p -> new Vec2(p[0], p[1])).toList();
    for (int i = 1; i < path.size(); i++) {
      if (!disc.cellsAlong(scene.grid(), path.get(i - 1), path.get(i)).stream()
          .allMatch(scene.grid()::isFree)) {
        return true;
      }
    }
    return false;
  }
}
