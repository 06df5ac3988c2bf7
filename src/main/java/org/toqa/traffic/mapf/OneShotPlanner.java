package org.toqa.traffic.mapf;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import org.toqa.grid.Cell;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.MapfResult.Culprit;
import org.toqa.traffic.mapf.MapfResult.Reason;
import org.toqa.traffic.mapf.MapfResult.Solved;
import org.toqa.traffic.mapf.MapfResult.Unsolved;

/**
 * Plans paths for all robots from start to goal: a first plan as soon as can be ({@link Lacam}), a
 * second one that is better ({@link PrioritisedPlanning} where the floor is not crowded, else
 * {@link GuidedPlanning}), and from the better of the two on {@link NeighbourhoodSearch}, on all
 * cores, until the deadline.
 *
 * <p>A robot goes to a neighbour in one of four directions or waits, each a step; no two share a
 * cell or change places.
 */
public final class OneShotPlanner {
  /** More would spend their time on taking over what the others have found. */
  private static final int MOST_THREADS = 8;

  private final long seed;
  private final int threads;

  /**
   * @param seed of all chance
   */
  public OneShotPlanner(long seed) {
    this(seed, Math.min(MOST_THREADS, Runtime.getRuntime().availableProcessors()));
  }

  /**
   * @param seed of all chance: the same seed, as many threads and enough time, the same plan
   * @param threads at work at once, the caller's among them
   */
  public OneShotPlanner(long seed, int threads) {
    this.seed = seed;
    this.threads = threads;
  }

  /**
   * Plans.
   *
   * @param deadline when to stop making the plan better; it has to come
   * @param onFirst told of the first plan at once
   */
  public MapfResult solve(MapfInstance instance, Deadline deadline, Consumer<MapfPlan> onFirst) {
    return firstFault(instance)
        .<MapfResult>map(fault -> fault)
        .orElseGet(() -> plan(instance, deadline, onFirst));
  }

  private static Optional<Unsolved> firstFault(MapfInstance instance) {
    Set<Cell> starts = new HashSet<>();
    Set<Cell> goals = new HashSet<>();
    for (int robot = 0; robot < instance.robotCount(); robot++) {
      Cell start = instance.starts().get(robot);
      Cell goal = instance.goals().get(robot);
      int from = instance.roads().vertex(start);
      int to = instance.roads().vertex(goal);
      if (from == RoadGraph.NONE) {
        return Optional.of(unsolved(Reason.START_BLOCKED, robot, start));
      }
      if (to == RoadGraph.NONE) {
        return Optional.of(unsolved(Reason.GOAL_BLOCKED, robot, goal));
      }
      if (!starts.add(start)) {
        return Optional.of(unsolved(Reason.START_SHARED, robot, start));
      }
      if (!goals.add(goal)) {
        return Optional.of(unsolved(Reason.GOAL_SHARED, robot, goal));
      }
      if (!instance.roads().canReach(from, to)) {
        return Optional.of(unsolved(Reason.NO_WAY, robot, goal));
      }
    }
    return Optional.empty();
  }

  private static Unsolved unsolved(Reason reason, int robot, Cell cell) {
    return new Unsolved(reason, new Culprit(robot, cell));
  }

  private MapfResult plan(MapfInstance instance, Deadline deadline, Consumer<MapfPlan> onFirst) {
    RoadGraph roads = instance.roads();
    int[] starts = vertices(roads, instance.starts());
    int[] goals = vertices(roads, instance.goals());
    char[][] distances = DistanceTables.of(roads, goals, deadline);
    if (distances.length < goals.length) {
      return new Unsolved(Reason.OUT_OF_TIME, null);
    }
    SplittableRandom random = new SplittableRandom(seed);
    StepSearch steps = new Pibt(roads, distances, goals, random.split(), true);
    Lacam lacam = new Lacam(roads, distances, starts, goals, random.split(), steps);
    return switch (lacam.search(deadline)) {
      case Lacam.Outcome.Exhausted() -> new Unsolved(Reason.NO_PLAN, null);
      case Lacam.Outcome.OutOfTime() -> new Unsolved(Reason.OUT_OF_TIME, null);
      case Lacam.Outcome.Found(List<int[]> configurations) -> {
        int[][] first = VertexPaths.of(configurations);
        onFirst.accept(new MapfPlan(roads, first));
        long lowerBound = lowerBound(distances, starts);
        int[][] best =
            new PlanImprovement(roads, distances, first, lowerBound, random)
                .improve(threads, deadline);
        yield new Solved(new MapfPlan(roads, best), lowerBound);
      }
    };
  }

  private static int[] vertices(RoadGraph roads, List<Cell> cells) {
    return cells.stream().mapToInt(roads::vertex).toArray();
  }

  private static long lowerBound(char[][] distances, int[] starts) {
    long sum = 0;
    for (int robot = 0; robot < starts.length; robot++) {
      sum += distances[robot][starts[robot]];
    }
    return sum;
  }
}
