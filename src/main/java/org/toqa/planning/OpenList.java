package org.toqa.planning;

import java.util.Arrays;

/**
 * A binary heap of states, the least key first, without an object an entry. Keys are f, and among
 * equal f h, so that the state nearest to the goal is first; or an estimate. It does not know what
 * became of a state; outdated entries are the search's to skip.
 */
public final class OpenList {
  /** Bits of h in a key; h stays below 2^31, f below 2^32. */
  private static final int H_BITS = 31;

  private long[] keys = new long[1024];
  private int[] states = new int[1024];
  private int size;

  public boolean isEmpty() {
    return size == 0;
  }

  void clear() {
    size = 0;
  }

  void push(int state, int g, int h) {
    push(state, (((long) g + h) << H_BITS) | h);
  }

  /**
   * Adds a state whose key is the estimated length of a path by it.
   *
   * @param estimate in any unit, at least 0, not to be mixed with other keys
   */
  public void push(int state, double estimate) {
    push(state, Double.doubleToRawLongBits(estimate)); // from 0 on in the order of the doubles
  }

  private void push(int state, long key) {
    if (size == keys.length) {
      keys = Arrays.copyOf(keys, 2 * size);
      states = Arrays.copyOf(states, 2 * size);
    }
    int hole = size++;
    while (hole > 0) {
      int parent = (hole - 1) >>> 1;
      if (keys[parent] <= key) {
        break;
      }
      keys[hole] = keys[parent];
      states[hole] = states[parent];
      hole = parent;
    }
    keys[hole] = key;
    states[hole] = state;
  }

  /** Takes the best state out; there must be one. */
  public int pop() {
    int best = states[0];
    long key = keys[--size];
    int state = states[size];
    int hole = 0;
    while (2 * hole + 1 < size) {
      int child = 2 * hole + 1;
      if (child + 1 < size && keys[child + 1] < keys[child]) {
        child++;
      }
      if (key <= keys[child]) {
        break;
      }
      keys[hole] = keys[child];
      states[hole] = states[child];
      hole = child;
    }
    keys[hole] = key;
    states[hole] = state;
    return best;
  }
}
