package org.toqa.app.bench;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.stream.DoubleStream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.MoveSet;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Scenario;
import org.toqa.planning.Path;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanChecker;
import org.toqa.planning.PlanResult;
import org.toqa.planning.PlanResult.Found;
import org.toqa.statistics.Percentiles;

/** The queries of a scenario, planned one after the other in a warm process, timed and checked. */
final class ScenarioRun {
  /** How far a length may be from the file's, as a share of it: the files are rounded. */
  private static final double TOLERANCE = 1e-4;

  /** How long the queries may run before they are timed. */
  private static final Duration WARM_UP = Duration.ofSeconds(3);

  private static final int MAX_WARM_UP_ROUNDS = 20;

  private final OccupancyGrid grid;
  private final List<Scenario> queries;
  private final MoveSet moves;
  private final Consumer<String> mismatchReporter;
  private final AtomicLong expanded = new AtomicLong();
  private final double[] lengths;
  private int solved;
  private int mismatches;
  private int turnsOnSpot;

  /**
   * @param solved how many paths were found
   * @param mismatches paths that break a rule, have a wrong length, or are missing
   * @param turnsOnSpot paths that turn on the spot
   * @param nodesPerSecond states expanded in a second of planning
   * @param meanMicros time of a query, microseconds
   * @param p50Micros its median
   * @param p99Micros its 99th percentile
   * @param maxMicros the longest
   */
  record Report(
      int queries,
      int solved,
      int mismatches,
      int turnsOnSpot,
      double nodesPerSecond,
      double meanMicros,
      double p50Micros,
      double p99Micros,
      double maxMicros) {}

  /**
   * @param mismatchReporter gets a sentence for each mismatch
   */
  ScenarioRun(
      OccupancyGrid grid,
      List<Scenario> queries,
      MoveSet moves,
      Consumer<String> mismatchReporter) {
    this.grid = grid;
    this.queries = queries;
    this.moves = moves;
    this.mismatchReporter = mismatchReporter;
    this.lengths = new double[queries.size()];
  }

  /** To be called once. */
  Report measure() {
    PathPlanner planner = moves.planner(expanded::addAndGet);
    warmUp(planner);
    expanded.set(0);
    double[] micros = new double[queries.size()];
    for (int i = 0; i < queries.size(); i++) {
      Scenario query = queries.get(i);
      long begin = System.nanoTime();
      PlanResult result = planner.plan(grid, query.start(), query.goal());
      micros[i] = (System.nanoTime() - begin) / 1e3;
      lengths[i] = recordResult(i, result);
    }
    Percentiles timings = new Percentiles(micros);
    double seconds = Arrays.stream(micros).sum() / 1e6;
    return new Report(
        queries.size(),
        solved,
        mismatches,
        turnsOnSpot,
        seconds == 0 ? 0 : expanded.get() / seconds,
        timings.mean(),
        timings.percentile(0.50),
        timings.percentile(0.99),
        timings.max());
  }

  /** The lengths found, in cells, in the order of the queries; -1 where there is no path. */
  DoubleStream lengths() {
    return Arrays.stream(lengths);
  }

  private void warmUp(PathPlanner planner) {
    long begin = System.nanoTime();
    for (int round = 0; round < MAX_WARM_UP_ROUNDS; round++) {
      for (Scenario query : queries) {
        if (System.nanoTime() - begin > WARM_UP.toNanos()) {
          return;
        }
        planner.plan(grid, query.start(), query.goal());
      }
    }
  }

  /** The length found, or -1; counts what the result is. */
  private double recordResult(int index, PlanResult result) {
    Path path = result instanceof Found(Path found) ? found : null;
    if (path != null) {
      solved++;
      turnsOnSpot += path.turnsOnSpot() > 0 ? 1 : 0;
    }
    mismatchMessage(queries.get(index), path)
        .ifPresent(
            sentence -> {
              mismatches++;
              mismatchReporter.accept("query %d: %s".formatted(index + 1, sentence));
            });
    return path == null ? -1 : path.cost();
  }

  /** What is wrong with an answer, in a sentence. */
  private Optional<String> mismatchMessage(Scenario query, @Nullable Path path) {
    double optimal = query.optimal();
    if (path == null) {
      return Optional.of("No path was found; the file knows one of %s.".formatted(optimal));
    }
    double over = path.cost() - optimal;
    boolean mayBeLonger = moves == MoveSet.HEADING;
    if (over < -TOLERANCE * optimal || (over > TOLERANCE * optimal && !mayBeLonger)) {
      return Optional.of("The length is %s; the file has %s.".formatted(path.cost(), optimal));
    }
    return PlanChecker.violation(grid, query.start(), query.goal(), path, moves.rule());
  }
}
