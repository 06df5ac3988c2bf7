package org.toqa.traffic;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Steps from every vertex to each of some goals: one breadth-first search a goal, the searches
 * shared among the processor's cores. A distance takes two bytes, so that 10,000 tables of a large
 * warehouse fit into memory.
 */
public final class DistanceTables {
  /** No path, or one of more steps than a table can say. */
  public static final int UNREACHABLE = Character.MAX_VALUE;

  /** Goals that are searched in one go, to keep the cores from queueing for work. */
  private static final int CHUNK = 8;

  private DistanceTables() {}

  /**
   * A table a goal, in the order of the goals; equal goals share theirs. Where the deadline passes,
   * the rest is missing and the answer is shorter.
   *
   * @param goals vertices
   * @return steps by goal and vertex, {@link #UNREACHABLE} where there is no path
   */
  public static char[][] of(RoadGraph roads, int[] goals, Deadline deadline) {
    int[] distinct = Arrays.stream(goals).distinct().toArray();
    char[][] byVertex = new char[roads.vertexCount()][];
    IntStream.range(0, (distinct.length + CHUNK - 1) / CHUNK)
        .parallel()
        .forEach(
            chunk -> {
              int[] queue = new int[roads.vertexCount()];
              int end = Math.min(distinct.length, (chunk + 1) * CHUNK);
              for (int k = chunk * CHUNK; k < end && !deadline.isPassed(); k++) {
                byVertex[distinct[k]] = of(roads, distinct[k], queue);
              }
            });
    return Arrays.stream(goals)
        .mapToObj(goal -> byVertex[goal])
        .takeWhile(table -> table != null)
        .toArray(char[][]::new);
  }

  private static char[] of(RoadGraph roads, int goal, int[] queue) {
    char[] steps = new char[roads.vertexCount()];
    Arrays.fill(steps, (char) UNREACHABLE);
    steps[goal] = 0;
    queue[0] = goal;
    int tail = 1;
    for (int head = 0; head < tail; head++) {
      int v = queue[head];
      int next = steps[v] + 1;
      if (next == UNREACHABLE) {
        break;
      }
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        int u = roads.predecessor(v, d);
        if (u != RoadGraph.NONE && steps[u] == UNREACHABLE) {
          steps[u] = (char) next;
          queue[tail++] = u;
        }
      }
    }
    return steps;
  }
}
