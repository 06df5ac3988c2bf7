package org.toqa.traffic.mapf;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * Plans one robot after the other, each around the paths of those before it; a robot that finds
 * none takes its path and sends those who stand in it back into the queue.
 *
 * <p>Idea: whoever has the shortest path goes first, because a long path bends around a short one
 * at less cost than in the other order, and because nobody has to wait until the last has passed
 * before it may stay at its goal. On a floor that is not crowded this comes within a few hundredths
 * of the lower bound, where the step by step rule of {@link Pibt} takes half as long again. A robot
 * rises in rank each time it finds no path, and only its equals and betters stay, so that two do
 * not turn each other out for ever.
 *
 * <p>Cost: a search a robot and a turning-out. On a crowded floor the queue does not empty: then it
 * gives up after some rounds.
 *
 * <p>M. Erdmann and T. Lozano-Perez, "On multiple moving objects", Algorithmica 1987; turning out
 * as in J. Li et al., "MAPF-LNS2", AAAI 2022, but whole robots instead of counted collisions.
 */
final class PrioritisedPlanning {
  /** Insertions a robot, on average, after which the floor counts as too crowded. */
  private static final int ROUNDS = 4;

  private final Spacing spacing;
  private final char[][] distances;
  private final int[] starts;
  private final int[] goals;
  private final ReservationTable reservations;
  private final SafeIntervalSearch search;

  /** Null for a robot in the queue. */
  private final int[] @Nullable [] paths;

  private final int[] ranks;
  private final PriorityQueue<Integer> queue;

  /**
   * @param known any plan; gives the starts and goals
   */
  PrioritisedPlanning(
      RoadGraph roads,
      Spacing spacing,
      char[][] distances,
      int[][] known,
      SplittableRandom random) {
    this.spacing = spacing;
    this.distances = distances;
    starts = Arrays.stream(known).mapToInt(path -> path[0]).toArray();
    goals = Arrays.stream(known).mapToInt(path -> path[path.length - 1]).toArray();
    int robots = known.length;
    int longest = IntStream.range(0, robots).map(this::shortest).max().orElse(0);
    reservations = ReservationTable.of(roads, spacing, longest + longest / 2);
    search = new SafeIntervalSearch(new StateGraph(roads, MotionModel.CLASSIC), reservations);
    paths = new int[robots][];
    ranks = new int[robots];
    double[] lengths =
        IntStream.range(0, robots).mapToDouble(r -> shortest(r) + random.nextDouble()).toArray();
    queue = new PriorityQueue<>(Comparator.comparingDouble(robot -> lengths[robot]));
    IntStream.range(0, robots).forEach(queue::add);
  }

  private int shortest(int robot) {
    return distances[robot][starts[robot]];
  }

  /** A path a robot, or null where the floor is too crowded or the budget is used up. */
  int @Nullable [][] plan(SearchBudget budget) {
    return plan(budget, Long.MAX_VALUE);
  }

  /**
   * @param mostEffort after which the floor counts as too crowded, as {@link
   *     SafeIntervalSearch#effort} counts it
   */
  int @Nullable [][] plan(SearchBudget budget, long mostEffort) {
    int insertionsLeft = ROUNDS * starts.length;
    while (!queue.isEmpty()) {
      if (!budget.takeIteration() || insertionsLeft-- == 0 || search.effort() > mostEffort) {
        return null;
      }
      int robot = queue.remove();
      int[] path = searchFor(robot);
      if (path == null) {
        path = searchOverruling(robot);
        requeueConflicting(path);
      }
      reservations.add(path);
      paths[robot] = path;
    }
    return Arrays.stream(paths).filter(path -> path != null).toArray(int[][]::new);
  }

  private int @Nullable [] searchFor(int robot) {
    return search.path(starts[robot], goals[robot], distances[robot], reservations.end());
  }

  /** Raises a robot in rank until there is a path around those of its rank and above. */
  private int[] searchOverruling(int robot) {
    while (true) {
      ranks[robot]++;
      List<int[]> ignored = new ArrayList<>();
      for (int other = 0; other < paths.length; other++) {
        int[] path = paths[other];
        if (path != null && ranks[other] < ranks[robot]) {
          ignored.add(path);
          reservations.remove(path);
        }
      }
      int[] path = searchFor(robot);
      ignored.forEach(reservations::add);
      if (path != null) {
        return path;
      }
    }
  }

  private void requeueConflicting(int[] newcomer) {
    for (int other = 0; other < paths.length; other++) {
      int[] path = paths[other];
      if (path != null && VertexPaths.hasConflict(spacing, path, newcomer)) {
        reservations.remove(path);
        paths[other] = null;
        queue.add(other);
      }
    }
  }
}
