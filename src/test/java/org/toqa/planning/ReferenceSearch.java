package org.toqa.planning;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * Dijkstra over (cell, direction as an angle in eighths), as plainly as it can be written: the
 * judge of the planners' lengths.
 */
final class ReferenceSearch {
  private static final int[][] DIRECTIONS = {
    {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}
  };

  /** What a change of direction costs, in cells; infinite where it is forbidden. */
  @FunctionalInterface
  interface TurnCost {
    double of(int eighths);
  }

  static final TurnCost FREE = eighths -> 0;
  static final TurnCost ARCS_ONLY = eighths -> eighths <= 1 ? 0 : Double.POSITIVE_INFINITY;
  static final TurnCost ARCS_AND_SPOT_TURNS = eighths -> eighths <= 1 ? 0 : eighths * 0.5;

  private record State(Cell cell, int direction) {}

  private record Entry(State state, double cost) {}

  private ReferenceSearch() {}

  static OptionalDouble shortest(OccupancyGrid grid, Cell start, Cell goal, TurnCost turnCost) {
    if (!grid.isFree(start) || !grid.isFree(goal)) {
      return OptionalDouble.empty();
    }
    PriorityQueue<Entry> open = new PriorityQueue<>(Comparator.comparingDouble(Entry::cost));
    Map<State, Double> settled = new HashMap<>();
    for (int direction = 0; direction < 8; direction++) {
      open.add(new Entry(new State(start, direction), 0));
    }
    while (!open.isEmpty()) {
      Entry best = open.remove();
      State state = best.state();
      if (settled.putIfAbsent(state, best.cost()) != null) {
        continue;
      }
      if (state.cell().equals(goal)) {
        return OptionalDouble.of(best.cost());
      }
      for (int direction = 0; direction < 8; direction++) {
        int apart = Math.abs(direction - state.direction());
        double turn = turnCost.of(Math.min(apart, 8 - apart));
        int dx = DIRECTIONS[direction][0];
        int dy = DIRECTIONS[direction][1];
        int x = state.cell().column();
        int y = state.cell().row();
        if (Double.isFinite(turn)
            && grid.isFree(x + dx, y + dy)
            && grid.isFree(x + dx, y)
            && grid.isFree(x, y + dy)
            && PlanChecker.isInDirection(grid, state.cell(), new Cell(x + dx, y + dy))) {
          State next = new State(new Cell(x + dx, y + dy), direction);
          open.add(new Entry(next, best.cost() + turn + Math.hypot(dx, dy)));
        }
      }
    }
    return OptionalDouble.empty();
  }
}
