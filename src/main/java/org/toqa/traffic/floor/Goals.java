package org.toqa.traffic.floor;

import static java.util.Comparator.nullsLast;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.traffic.RoadGraph;

/**
 * A goal for each robot that is planned, all different: the lane cell of its own goal if it can
 * have that, else a place near to it; and for a robot that wants nothing the place where it stands,
 * unless another wants that. Whoever has a place or a way to it keeps it, then whoever waits
 * longest chooses.
 */
final class Goals {
  /** A robot that waits for its place this many lane cells from it is near enough. */
  private static final int NEAR = 4;

  private final Ground ground;
  private final Lanes lanes;
  private final RoadGraph roads;
  private final List<Mover> planned;
  private final int[] starts;

  /** Cells of the floor where nobody shall stay. */
  private final BitSet wished;

  private final int[] assigned;
  private final Map<Integer, String> taken = new HashMap<>();

  /** How many that want to go somewhere have no way there, whoever made room. */
  private int unreachable;

  Goals(
      Ground ground,
      Lanes lanes,
      RoadGraph roads,
      List<Mover> planned,
      int[] starts,
      BitSet wished) {
    this.ground = ground;
    this.lanes = lanes;
    this.roads = roads;
    this.planned = planned;
    this.starts = starts;
    this.wished = wished;
    this.assigned = new int[planned.size()];
    List<Integer> order = new ArrayList<>();
    for (int i = 0; i < planned.size(); i++) {
      order.add(i);
    }
    order.sort(
        Comparator.<Integer, Boolean>comparing(i -> planned.get(i).goal == null)
            .thenComparing(i -> planned.get(i).isUnserved())
            .thenComparing(
                i -> planned.get(i).waitingSince, nullsLast(Comparator.<Instant>naturalOrder())));
    for (int i : order) {
      assigned[i] = goal(i);
      taken.put(assigned[i], planned.get(i).name);
    }
  }

  int[] assigned() {
    return assigned;
  }

  int unreachable() {
    return unreachable;
  }

  private int goal(int i) {
    Mover m = planned.get(i);
    m.takenBy = null;
    if (m.goal == null) {
      return nearest(starts[i], starts[i]);
    }
    int vertex = approach(m, m.goal, starts[i]);
    if (vertex == RoadGraph.NONE) {
      unreachable++;
      return nearest(starts[i], starts[i]);
    }
    m.takenBy = taken.get(vertex);
    return isOpen(vertex) ? vertex : nearest(vertex, starts[i]);
  }

  /** The nearest lane cell to its goal from which it can go straight there. */
  private int approach(Mover m, Vec2 goal, int start) {
    for (Cell cell : lanes.near(goal)) {
      int vertex = roads.vertex(cell);
      if (vertex != RoadGraph.NONE
          && roads.isConnected(start, vertex)
          && !SweptCells.straight(ground.grid(), lanes.lattice().centre(cell), goal, m.radius)
              .intersects(ground.closed())) {
        return vertex;
      }
    }
    return RoadGraph.NONE;
  }

  /**
   * A vertex near to the wanted one that nobody else goes to. A robot that is near already stays
   * where it is; otherwise waiting robots would change places for ever.
   */
  private int nearest(int to, int start) {
    Deque<Integer> queue = new ArrayDeque<>(List.of(to));
    Map<Integer, Integer> steps = new HashMap<>(Map.of(to, 0));
    int found = RoadGraph.NONE;
    while (!queue.isEmpty()) {
      int vertex = queue.poll();
      int here = steps.getOrDefault(vertex, 0);
      if (found != RoadGraph.NONE && here > NEAR) {
        return found;
      }
      if (isOpen(vertex)) {
        if (vertex == start) {
          return start;
        }
        found = found == RoadGraph.NONE ? vertex : found;
      }
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        int next = roads.neighbour(vertex, d);
        if (next != RoadGraph.NONE && steps.putIfAbsent(next, here + 1) == null) {
          queue.add(next);
        }
      }
    }
    return found == RoadGraph.NONE ? start : found;
  }

  private boolean isOpen(int vertex) {
    return !taken.containsKey(vertex) && !lanes.touches(roads.cell(vertex), wished);
  }
}
