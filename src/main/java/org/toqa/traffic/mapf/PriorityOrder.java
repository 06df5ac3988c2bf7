package org.toqa.traffic.mapf;

import java.util.Comparator;
import java.util.stream.IntStream;

/** Who chooses its place before whom, where all robots step at once. */
final class PriorityOrder {
  private PriorityOrder() {}

  /** Whoever has furthest to go is in front. */
  static int[] farthestFirst(char[][] distances, int[] places) {
    return IntStream.range(0, places.length)
        .boxed()
        .sorted(Comparator.comparingInt(robot -> -distances[robot][places[robot]]))
        .mapToInt(Integer::intValue)
        .toArray();
  }

  /**
   * Whoever is at its goal goes behind all others; otherwise the order stays, so that the longer a
   * robot is on its path, the further in front it is.
   */
  static int[] unarrivedFirst(int[] order, int[] places, int[] goals) {
    int[] sorted = new int[order.length];
    int front = 0;
    for (int robot : order) {
      if (places[robot] != goals[robot]) {
        sorted[front++] = robot;
      }
    }
    for (int robot : order) {
      if (places[robot] == goals[robot]) {
        sorted[front++] = robot;
      }
    }
    return sorted;
  }
}
