package org.toqa.traffic.mapf;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * Makes the most of a first plan and the time left.
 *
 * <p>Idea: planning one robot after the other comes near the lower bound where it gets through, and
 * never does where the floor is crowded; there the way is to keep robots out of each other's way.
 * Both are tried at once where there are threads; the first plan shows where one is hopeless. What
 * is better in the end is improved by as many searches as there are threads.
 */
final class PlanImprovement {
  /** Of the time left after the first plan, what the second may take. */
  private static final double SHARE_OF_SECOND = 0.4;

  /** Sum of costs over the lower bound of a first plan beyond which one by one is hopeless. */
  private static final double TOO_CROWDED = 2.5;

  /** Work for each step of the lower bound after which one by one is hopeless. */
  private static final long EFFORT_PER_STEP = 110;

  private final RoadGraph roads;
  private final char[][] distances;
  private final Spacing spacing;
  private final int[][] first;
  private final long lowerBound;
  private final SplittableRandom randomOneByOne;
  private final SplittableRandom randomGuided;
  private final SplittableRandom randomSearches;

  /**
   * @param distances a table a robot: steps to its goal
   * @param first a path a robot
   * @param lowerBound steps, of all robots together
   */
  PlanImprovement(
      RoadGraph roads,
      char[][] distances,
      int[][] first,
      long lowerBound,
      SplittableRandom random) {
    this.roads = roads;
    this.distances = distances;
    this.spacing = Spacing.none(roads);
    this.first = first;
    this.lowerBound = lowerBound;
    this.randomOneByOne = random.split();
    this.randomGuided = random.split();
    this.randomSearches = random.split();
  }

  /**
   * Goes on until the deadline, or until the sum of costs has come down to the lower bound.
   *
   * @param threads at work at once, the caller's among them
   */
  int[][] improve(int threads, Deadline deadline) {
    if (threads == 1) {
      Deadline soon = deadline.afterShare(SHARE_OF_SECOND);
      int[][] best = betterThanFirst(oneByOne(soon).or(() -> guided(soon)));
      search(best).improve(lowerBound, SearchBudget.until(deadline));
      return best;
    }
    try (ExecutorService others =
        Executors.newFixedThreadPool(
            threads - 1, Thread.ofPlatform().daemon().name("one-shot-", 0).factory())) {
      return improveWith(threads, others, deadline);
    }
  }

  /**
   * @param others the threads beside the caller's
   */
  int[][] improveWith(int threads, Executor others, Deadline deadline) {
    int[][] best = betterThanFirst(second(others, deadline.afterShare(SHARE_OF_SECOND)));
    List<NeighbourhoodSearch> searches = new ArrayList<>();
    searches.add(search(best));
    while (searches.size() < threads) {
      searches.add(search(best.clone()));
    }
    new ParallelNeighbourhoods(searches, others).improve(lowerBound, SearchBudget.until(deadline));
    return best;
  }

  /** The guided plan is made meanwhile, and left where one by one gets through. */
  private Optional<int[][]> second(Executor others, Deadline deadline) {
    AtomicBoolean isFound = new AtomicBoolean();
    Deadline unlessFound =
        new Deadline(
            () -> isFound.get() ? deadline.end() : deadline.ticker().getAsLong(), deadline.end());
    CompletableFuture<Optional<int[][]>> guided =
        CompletableFuture.supplyAsync(() -> guided(unlessFound), others);
    Optional<int[][]> oneByOne = oneByOne(deadline);
    isFound.set(oneByOne.isPresent());
    Optional<int[][]> meanwhile = guided.join();
    return oneByOne.or(() -> meanwhile);
  }

  private Optional<int[][]> oneByOne(Deadline deadline) {
    if (VertexPaths.sumOfCosts(first) > TOO_CROWDED * lowerBound) {
      return Optional.empty();
    }
    return Optional.ofNullable(
        new PrioritisedPlanning(roads, spacing, distances, first, randomOneByOne)
            .plan(SearchBudget.until(deadline), EFFORT_PER_STEP * lowerBound));
  }

  private Optional<int[][]> guided(Deadline deadline) {
    int[] starts = Arrays.stream(first).mapToInt(path -> path[0]).toArray();
    int[] goals = Arrays.stream(first).mapToInt(path -> path[path.length - 1]).toArray();
    return new GuidedPlanning(roads, distances, starts, goals, randomGuided).plan(deadline);
  }

  /** A copy, for the searches to change. */
  private int[][] betterThanFirst(Optional<int[][]> second) {
    return second
        .filter(paths -> VertexPaths.sumOfCosts(paths) < VertexPaths.sumOfCosts(first))
        .orElse(first)
        .clone();
  }

  private NeighbourhoodSearch search(int[][] paths) {
    return new NeighbourhoodSearch(roads, spacing, distances, paths, randomSearches.split());
  }
}
