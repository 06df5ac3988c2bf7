package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;

/**
 * Lazy constraints addition search: finds paths for all robots, or proves that there are none.
 *
 * <p>Idea: a depth-first search over configurations (the places of all robots at once). A
 * configuration has far too many successors to list, so they come one at a time from {@link
 * StepSearch}; each further visit of the same configuration adds one more order ("robot i goes to
 * v"), and the orders, taken in breadth, run through all successors in the end. That makes the
 * quick rule of PIBT complete: it fails only where there is nothing to find.
 *
 * <p>Cost: where PIBT needs no correction, one step of it for every step of the plan.
 *
 * <p>K. Okumura, "LaCAM: search-based algorithm for quick multi-agent pathfinding", AAAI 2023.
 */
final class Lacam {
  private final RoadGraph roads;
  private final char[][] distances;
  private final int[] starts;
  private final int[] goals;
  private final StepSearch stepSearch;
  private final SplittableRandom random;

  /**
   * @param stepSearch finds the step from one configuration to the next
   */
  Lacam(
      RoadGraph roads,
      char[][] distances,
      int[] starts,
      int[] goals,
      SplittableRandom random,
      StepSearch stepSearch) {
    this.roads = roads;
    this.distances = distances;
    this.starts = starts;
    this.goals = goals;
    this.random = random;
    this.stepSearch = stepSearch;
  }

  /**
   * Orders for one step, as a list that shares its tail.
   *
   * @param depth how many there are
   */
  record Constraints(@Nullable Constraints rest, int depth, int robot, int place) {
    static final Constraints EMPTY = new Constraints(null, 0, NONE, NONE);

    Constraints parent() {
      return rest == null ? EMPTY : rest;
    }

    Constraints with(int anotherRobot, int itsPlace) {
      return new Constraints(this, depth + 1, anotherRobot, itsPlace);
    }
  }

  /** A configuration, as it was first reached. */
  private static final class Node {
    final @Nullable Node parent;
    final int[] places;
    final int[] order;
    final Deque<Constraints> untried = new ArrayDeque<>(List.of(Constraints.EMPTY));

    Node(@Nullable Node parent, int[] places, int[] order) {
      this.parent = parent;
      this.places = places;
      this.order = order;
    }
  }

  /** The places of all robots, to look a configuration up by. */
  private record Key(int[] places, int hash) {
    static Key of(int[] places) {
      return new Key(places, Arrays.hashCode(places));
    }

    @Override
    public int hashCode() {
      return hash;
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Key that && Arrays.equals(places, that.places);
    }
  }

  /** What the search came to. */
  sealed interface Outcome {
    /** The configurations in order, from the start to the goal. */
    record Found(List<int[]> configurations) implements Outcome {}

    record Exhausted() implements Outcome {}

    record OutOfTime() implements Outcome {}
  }

  Outcome search(Deadline deadline) {
    Map<Key, Node> explored = new HashMap<>();
    ArrayList<Node> open = new ArrayList<>();
    Node root = new Node(null, starts, PriorityOrder.farthestFirst(distances, starts));
    explored.put(Key.of(starts), root);
    open.add(root);
    int[] next = new int[starts.length];
    while (!open.isEmpty()) {
      if (deadline.isPassed()) {
        return new Outcome.OutOfTime();
      }
      Node node = open.getLast();
      if (Arrays.equals(node.places, goals)) {
        return new Outcome.Found(trace(node));
      }
      Constraints constraints = node.untried.poll();
      if (constraints == null) {
        open.removeLast();
        continue;
      }
      branch(node, constraints);
      if (!stepSearch.step(node.places, node.order, constraints, next)) {
        continue;
      }
      Key key = Key.of(next);
      Node known = explored.get(key);
      if (known != null) {
        open.add(known);
      } else {
        int[] places = next.clone();
        Node child =
            new Node(node, places, PriorityOrder.unarrivedFirst(node.order, places, goals));
        explored.put(new Key(places, key.hash()), child);
        open.add(child);
      }
    }
    return new Outcome.Exhausted();
  }

  /** Puts the orders of this and one more robot in the queue, for later visits of the node. */
  private void branch(Node node, Constraints constraints) {
    if (constraints.depth() == node.order.length) {
      return;
    }
    int robot = node.order[constraints.depth()];
    int here = node.places[robot];
    int turn = random.nextInt(DIRECTIONS);
    for (int k = 0; k < DIRECTIONS; k++) {
      int place = roads.neighbour(here, (k + turn) % DIRECTIONS);
      if (place != NONE) {
        node.untried.add(constraints.with(robot, place));
      }
    }
    node.untried.add(constraints.with(robot, here));
  }

  private static List<int[]> trace(Node last) {
    ArrayDeque<int[]> configurations = new ArrayDeque<>();
    for (Node node = last; node != null; node = node.parent) {
      configurations.addFirst(node.places);
    }
    return List.copyOf(configurations);
  }
}
