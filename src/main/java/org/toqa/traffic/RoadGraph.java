package org.toqa.traffic;

import java.util.Arrays;
import java.util.BitSet;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/**
 * The free cells of a grid as vertices 0, 1, 2 ... in reading order, each joined with its free
 * neighbours in the four directions, as far as the passage between them is open. Every edge can be
 * driven both ways, but where the grid's rules forbid one of them. Flat arrays, because planners
 * ask for neighbours some million times a second. Immutable.
 */
public final class RoadGraph {
  public static final int EAST = 0;
  public static final int NORTH = 1;
  public static final int WEST = 2;
  public static final int SOUTH = 3;

  /** Directions count counter-clockwise from east, so +1 is a left turn. */
  public static final int DIRECTIONS = 4;

  /** No such vertex. */
  public static final int NONE = -1;

  private final OccupancyGrid grid;
  private final int[] vertexAt;
  private final int[] cellOf;
  private final int[] neighbours;

  /** From where one comes, by the direction in which that lies; the neighbours, if all is both. */
  private final int[] predecessors;

  private final int[] degrees;
  private final int[] components;
  private final int largestComponent;
  private int largestPart;

  /** Whether one can go from a cell to the one beside it, and back. */
  @FunctionalInterface
  public interface Passage {
    /**
     * @param column of the cell, from 0 to the east
     * @param row of the cell, from 0 to the south
     * @param direction {@link #EAST} or {@link #SOUTH}
     */
    boolean isOpen(int column, int row, int direction);
  }

  /** Is told of vertices one after the other. */
  @FunctionalInterface
  public interface Visitor {
    /**
     * @param steps how many it is from the first vertex
     * @return whether to go on to the next vertex
     */
    boolean visit(int vertex, int steps);
  }

  /** Every free cell is joined with its free neighbours. */
  public RoadGraph(OccupancyGrid grid) {
    this(grid, (column, row, direction) -> true);
  }

  /**
   * @param passage asked once for each pair of free cells
   */
  public RoadGraph(OccupancyGrid grid, Passage passage) {
    this.grid = grid;
    int cells = grid.width() * grid.height();
    vertexAt = new int[cells];
    int[] free = new int[cells];
    int count = 0;
    for (int index = 0; index < cells; index++) {
      boolean isFree = grid.isFree(index % grid.width(), index / grid.width());
      vertexAt[index] = isFree ? count : NONE;
      if (isFree) {
        free[count++] = index;
      }
    }
    cellOf = Arrays.copyOf(free, count);
    neighbours = new int[count * DIRECTIONS];
    Arrays.fill(neighbours, NONE);
    degrees = new int[count];
    for (int v = 0; v < count; v++) {
      join(v, EAST, vertex(columnOf(v) + 1, rowOf(v)), passage);
      join(v, SOUTH, vertex(columnOf(v), rowOf(v) + 1), passage);
    }
    components = new int[count];
    largestComponent = labelComponents();
    predecessors = grid.rules().isDirected() ? neighbours.clone() : neighbours;
    forbidMoves();
  }

  private void forbidMoves() {
    for (int v = 0; isDirected() && v < vertexCount(); v++) {
      for (int d = 0; d < DIRECTIONS; d++) {
        if ((grid.forbiddenFrom(cellOf[v]) >> (2 * d) & 1) == 1) {
          neighbours[v * DIRECTIONS + d] = NONE;
        }
        if ((grid.forbiddenInto(cellOf[v]) >> (2 * d) & 1) == 1) {
          predecessors[v * DIRECTIONS + d] = NONE;
        }
      }
    }
  }

  private void join(int vertex, int direction, int next, Passage passage) {
    if (next != NONE && passage.isOpen(columnOf(vertex), rowOf(vertex), direction)) {
      neighbours[vertex * DIRECTIONS + direction] = next;
      neighbours[next * DIRECTIONS + opposite(direction)] = vertex;
      degrees[vertex]++;
      degrees[next]++;
    }
  }

  /** Labels the connected parts and answers the label of the largest. */
  private int labelComponents() {
    Arrays.fill(components, NONE);
    int[] queue = new int[vertexCount()];
    int largest = NONE;
    for (int root = 0; root < vertexCount(); root++) {
      if (components[root] != NONE) {
        continue;
      }
      components[root] = root;
      queue[0] = root;
      int tail = 1;
      for (int head = 0; head < tail; head++) {
        for (int d = 0; d < DIRECTIONS; d++) {
          int u = neighbour(queue[head], d);
          if (u != NONE && components[u] == NONE) {
            components[u] = root;
            queue[tail++] = u;
          }
        }
      }
      if (tail > largestPart) {
        largestPart = tail;
        largest = root;
      }
    }
    return largest;
  }

  public OccupancyGrid grid() {
    return grid;
  }

  /** How many free cells there are. */
  public int vertexCount() {
    return cellOf.length;
  }

  /** {@link #NONE} where the cell is not free or not on the grid. */
  public int vertex(int column, int row) {
    return grid.contains(column, row) ? vertexAt[row * grid.width() + column] : NONE;
  }

  /** {@link #NONE} where the cell is not free or not on the grid. */
  public int vertex(Cell cell) {
    return vertex(cell.column(), cell.row());
  }

  public Cell cell(int vertex) {
    return grid.cell(cellOf[vertex]);
  }

  /** From 0, to the east. */
  public int columnOf(int vertex) {
    return cellOf[vertex] % grid.width();
  }

  /** From 0 at the top, to the south. */
  public int rowOf(int vertex) {
    return cellOf[vertex] / grid.width();
  }

  /** The vertex next to this one in a direction, or {@link #NONE}. */
  public int neighbour(int vertex, int direction) {
    return neighbours[vertex * DIRECTIONS + direction];
  }

  /** The vertex in a direction from which one comes to this one, or {@link #NONE}. */
  public int predecessor(int vertex, int direction) {
    return predecessors[vertex * DIRECTIONS + direction];
  }

  /** Whether there may be edges that are driven one way only. */
  public boolean isDirected() {
    return predecessors != neighbours;
  }

  /** Whether one can go from a vertex to another one beside it. */
  public boolean hasEdge(int from, int to) {
    for (int d = 0; d < DIRECTIONS; d++) {
      if (neighbour(from, d) == to) {
        return true;
      }
    }
    return false;
  }

  /**
   * The direction that leads from a vertex to one beside it.
   *
   * @throws IllegalArgumentException if the two are not joined
   */
  public int direction(int from, int to) {
    for (int d = 0; d < DIRECTIONS; d++) {
      if (neighbour(from, d) == to) {
        return d;
      }
    }
    throw new IllegalArgumentException(
        "There is no edge from " + cell(from) + " to " + cell(to) + ".");
  }

  /**
   * Visits the vertices that can be reached from one, by their number of steps from there; of equal
   * ones in the order of their predecessors and of the directions (breadth-first search).
   */
  public void visitByDistance(int from, Visitor visitor) {
    BitSet seen = new BitSet();
    int[] queue = new int[64];
    queue[0] = from;
    seen.set(from);
    int tail = 1;
    int steps = 0;
    int levelEnd = 1;
    for (int head = 0; head < tail; head++) {
      if (head == levelEnd) {
        steps++;
        levelEnd = tail;
      }
      if (!visitor.visit(queue[head], steps)) {
        return;
      }
      if (queue.length < tail + DIRECTIONS) {
        queue = Arrays.copyOf(queue, 2 * queue.length);
      }
      for (int d = 0; d < DIRECTIONS; d++) {
        int next = neighbour(queue[head], d);
        if (next != NONE && !seen.get(next)) {
          seen.set(next);
          queue[tail++] = next;
        }
      }
    }
  }

  /** How many vertices it is joined with, one way or the other, 0 to 4. */
  public int degree(int vertex) {
    return degrees[vertex];
  }

  /** The direction back. */
  public static int opposite(int direction) {
    return direction ^ 2;
  }

  /**
   * Whether a vertex can be reached from another one. It takes a search where there are edges that
   * are driven one way only.
   */
  public boolean canReach(int from, int to) {
    if (components[from] != components[to] || !isDirected()) {
      return components[from] == components[to];
    }
    boolean[] isFound = {false};
    visitByDistance(
        from,
        (vertex, steps) -> {
          isFound[0] = vertex == to;
          return !isFound[0];
        });
    return isFound[0];
  }

  /** How many vertices the largest connected part has, whichever way its edges are driven. */
  public int largestPartSize() {
    return largestPart;
  }

  public boolean isInLargestPart(int vertex) {
    return components[vertex] == largestComponent;
  }
}
