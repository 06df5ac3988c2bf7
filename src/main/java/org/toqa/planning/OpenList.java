package org.toqa.planning;

import java.util.Arrays;

/**
 * A binary heap of states by f, and among equal f by h: the state nearest to the goal first. It
 * does not know what became of a state; outdated entries are the search's to skip.
 */
final class OpenList {
  /** Bits of h in a key; h stays below 2^31, f below 2^32. */
  private static final int H_BITS = 31;

  private long[] keys = new long[1024];
  private int[] states = new int[1024];
  private int size;

  boolean isEmpty() {
    return size == 0;
  }

  void clear() {
    size = 0;
  }

  void push(int state, int g, int h) {
    if (size == keys.length) {
      keys = Arrays.copyOf(keys, 2 * size);
      states = Arrays.copyOf(states, 2 * size);
    }
    long key = (((long) g + h) << H_BITS) | h;
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

  /** Takes the best state out. */
  int pop() {
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
