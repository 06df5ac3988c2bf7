package org.toqa.traffic.mapf;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;

/**
 * A plan for a crowded floor: all robots step by step with {@link Pibt}, on paths that {@link
 * TrafficGuide} leads around each other, and the last ones home by {@link Lacam}.
 *
 * <p>Idea: the shortest paths of many robots lead against each other through the same aisles, and
 * what that costs no rule for a single step can mend. Guided, most arrive in a fraction of the
 * time; but the last few may turn each other out for ever, as each keeps to its one-way streets.
 * From some moment on the shortest paths serve better. Several moments are tried, and the plan with
 * the least sum of costs counts.
 *
 * <p>Cost: a guide's search a robot, then a few times a step of PIBT for every step of the plan.
 */
final class GuidedPlanning {
  /** When to leave the guide, in parts of the longest of the robots' shortest paths. */
  private static final double[] LEAVING = {0.6, 0.75, 0.9, 1.1};

  /** Robots times vertices, beyond which the guide would take too much memory: 128 MB. */
  private static final long MOST_DISTANCES = 1L << 26;

  /** Of the time left, what getting the last ones home may take each time. */
  private static final double SHARE_OF_LAST = 0.5;

  private final RoadGraph roads;
  private final char[][] distances;
  private final int[] starts;
  private final int[] goals;
  private final SplittableRandom random;

  /**
   * @param distances a table a robot: steps to its goal
   */
  GuidedPlanning(
      RoadGraph roads, char[][] distances, int[] starts, int[] goals, SplittableRandom random) {
    this.roads = roads;
    this.distances = distances;
    this.starts = starts;
    this.goals = goals;
    this.random = random;
  }

  /** A path a robot; empty where the time was too short, or the floor is too large. */
  Optional<int[][]> plan(Deadline deadline) {
    char[][] guided = guidedDistances(deadline);
    if (guided.length < starts.length) {
      return Optional.empty();
    }
    Pibt steps = new Pibt(roads, guided, goals, random.split(), true);
    int longest = IntStream.range(0, starts.length).map(this::shortest).max().orElse(0);
    List<int[]> configurations = new ArrayList<>(List.of(starts));
    int[] order = PriorityOrder.farthestFirst(distances, starts);
    Optional<int[][]> best = Optional.empty();
    for (double part : LEAVING) {
      order = follow(steps, order, configurations, (int) (part * longest), deadline);
      best = cheaper(best, withLast(configurations, deadline));
    }
    return best;
  }

  private int shortest(int robot) {
    return distances[robot][starts[robot]];
  }

  /**
   * Costs to its goal for each robot, in an order by chance; fewer where the time was too short.
   */
  private char[][] guidedDistances(Deadline deadline) {
    int robots = starts.length;
    if ((long) robots * roads.vertexCount() > MOST_DISTANCES) {
      return new char[0][];
    }
    char[][] guided = new char[robots][];
    TrafficGuide guide = new TrafficGuide(roads);
    for (int robot : shuffled(robots)) {
      if (deadline.isPassed()) {
        return new char[0][];
      }
      guided[robot] = guide.announce(starts[robot], goals[robot]);
    }
    return guided;
  }

  private int[] shuffled(int count) {
    int[] numbers = IntStream.range(0, count).toArray();
    for (int k = count - 1; k > 0; k--) {
      int other = random.nextInt(k + 1);
      int number = numbers[k];
      numbers[k] = numbers[other];
      numbers[other] = number;
    }
    return numbers;
  }

  /** Lets all step on until so many steps are planned; answers the order after them. */
  private int[] follow(
      Pibt steps, int[] firstOrder, List<int[]> configurations, int until, Deadline deadline) {
    int[] order = firstOrder;
    int[] places = configurations.getLast();
    while (configurations.size() <= until
        && !Arrays.equals(places, goals)
        && !deadline.isPassed()) {
      int[] next = new int[places.length];
      if (!steps.step(places, order, Lacam.Constraints.EMPTY, next)) {
        break;
      }
      configurations.add(next);
      order = PriorityOrder.unarrivedFirst(order, next, goals);
      places = next;
    }
    return order;
  }

  private Optional<int[][]> withLast(List<int[]> configurations, Deadline deadline) {
    int[] places = configurations.getLast();
    Pibt steps = new Pibt(roads, distances, goals, random.split(), true);
    Lacam lacam = new Lacam(roads, distances, places, goals, random.split(), steps);
    if (!(lacam.search(deadline.afterShare(SHARE_OF_LAST))
        instanceof Lacam.Outcome.Found(List<int[]> rest))) {
      return Optional.empty();
    }
    List<int[]> whole = new ArrayList<>(configurations);
    whole.addAll(rest.subList(1, rest.size()));
    return Optional.of(VertexPaths.of(whole));
  }

  private static Optional<int[][]> cheaper(Optional<int[][]> one, Optional<int[][]> other) {
    if (one.isEmpty() || other.isEmpty()) {
      return one.or(() -> other);
    }
    return VertexPaths.sumOfCosts(other.get()) < VertexPaths.sumOfCosts(one.get()) ? other : one;
  }
}
