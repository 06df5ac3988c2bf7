package org.toqa.traffic.lifelong;

import java.util.BitSet;

/**
 * What operations are chosen for: the robots, counted from 0, and where they are going.
 *
 * @param order the robots by falling priority
 * @param ranks by robot: its place in the order
 * @param distances costs to the goal by robot and state, as {@link Guidance} has them
 * @param goals vertices, or {@code NONE}
 * @param fixed the robots that keep the operation they have
 * @param delays by robot: the steps in which it does not go yet
 * @param weights by robot: what a step of its counts for, where robots exchange
 */
record SearchTask(
    int[] order,
    int[] ranks,
    char[][] distances,
    int[] goals,
    BitSet fixed,
    int[] delays,
    int[] weights) {

  static SearchTask of(
      int[] order, char[][] distances, int[] goals, BitSet fixed, int[] delays, int[] weights) {
    int[] ranks = new int[order.length];
    for (int k = 0; k < order.length; k++) {
      ranks[order[k]] = k;
    }
    return new SearchTask(order, ranks, distances, goals, fixed, delays, weights);
  }

  int robots() {
    return order.length;
  }
}
