package org.toqa.traffic.mapf;

import java.util.List;
import org.toqa.traffic.Spacing;

/** Paths as planners hold them: vertices at the times 0, 1, 2 ... up to the arrival. */
public final class VertexPaths {
  private VertexPaths() {}

  /** The vertex at a time; the goal from the arrival on. */
  public static int at(int[] path, int time) {
    return path[Math.min(time, path.length - 1)];
  }

  /** Whether two robots come too near to each other or change places. */
  static boolean hasConflict(Spacing spacing, int[] one, int[] other) {
    if (spacing.isTooNear(one[0], other[0])) {
      return true;
    }
    int last = Math.max(one.length, other.length);
    for (int t = 1; t < last; t++) {
      int a = at(one, t);
      int b = at(other, t);
      if (spacing.isTooNear(a, b)
          || (spacing.isTooNear(a, at(other, t - 1)) && spacing.isTooNear(b, at(one, t - 1)))) {
        return true;
      }
    }
    return false;
  }

  /** A path a robot, from the places of all robots step by step. */
  public static int[][] of(List<int[]> configurations) {
    int last = configurations.size() - 1;
    int robots = configurations.getFirst().length;
    int[][] paths = new int[robots][];
    for (int robot = 0; robot < robots; robot++) {
      int goal = configurations.get(last)[robot];
      int arrival = last;
      while (arrival > 0 && configurations.get(arrival - 1)[robot] == goal) {
        arrival--;
      }
      paths[robot] = new int[arrival + 1];
      for (int t = 0; t <= arrival; t++) {
        paths[robot][t] = configurations.get(t)[robot];
      }
    }
    return paths;
  }

  /** Steps until the arrival, summed over the robots. */
  public static long sumOfCosts(int[][] paths) {
    long sum = 0;
    for (int[] path : paths) {
      sum += path.length - 1;
    }
    return sum;
  }
}
