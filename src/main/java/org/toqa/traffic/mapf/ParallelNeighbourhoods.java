package org.toqa.traffic.mapf;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.NeighbourhoodSearch.Change;

/**
 * Several {@link NeighbourhoodSearch}es at work on one plan, each in a thread of its own.
 *
 * <p>Idea: each has the plan and its reservations for itself, so that nobody waits for a lock.
 * After some work all stop; the first takes over from the others what still fits, and the others
 * take over its plan. On a large floor the groups of two searches seldom meet, and nearly all fits.
 *
 * <p>The work of a round is counted, so that equal searches come to the same plan however fast they
 * were.
 */
final class ParallelNeighbourhoods {
  /** Work of a round, as {@link SafeIntervalSearch#effort} counts it: about 5 milliseconds. */
  private static final long EFFORT = 50_000;

  private final List<NeighbourhoodSearch> searches;
  private final Executor threads;

  /**
   * @param searches of equal plans; the first one's plan becomes better
   * @param threads for all searches but the first, which the caller's thread does
   */
  ParallelNeighbourhoods(List<NeighbourhoodSearch> searches, Executor threads) {
    this.searches = List.copyOf(searches);
    this.threads = threads;
  }

  /**
   * Goes on while the budget lasts, or until the sum of costs has come down to the lower bound.
   *
   * @param lowerBound steps, of all robots together
   * @param budget asked by the caller's thread alone, before each iteration of the first search
   */
  void improve(long lowerBound, SearchBudget budget) {
    NeighbourhoodSearch first = searches.getFirst();
    List<NeighbourhoodSearch> others = searches.subList(1, searches.size());
    while (first.cost() > lowerBound && !budget.isUsedUp()) {
      List<CompletableFuture<List<Change>>> found = new ArrayList<>();
      for (NeighbourhoodSearch search : others) {
        found.add(
            CompletableFuture.supplyAsync(
                () -> search.improveFor(EFFORT, lowerBound, SearchBudget.until(Deadline.none())),
                threads));
      }
      first.improveFor(EFFORT, lowerBound, budget);
      found.forEach(changes -> changes.join().forEach(first::adopt));
      others.forEach(search -> search.follow(first));
    }
  }
}
