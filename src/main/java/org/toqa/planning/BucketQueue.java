package org.toqa.planning;

import java.util.Arrays;

/**
 * A priority queue of items, from 0 on, with integer keys that never fall: a key that is pushed is
 * at least the last one popped and at most {@link #SPAN} - 1 above it. So the keys fit round a ring
 * of buckets, and each operation takes the same short time (Dial, "Algorithm 360", CACM 1969). Of
 * equal keys the last one pushed is popped first: a search goes on where it is.
 */
final class BucketQueue {
  /** A step of a search adds at most two of its own lengths, and a half turn on the spot. */
  static final int SPAN = 2048;

  /** By key modulo SPAN: the place of its top entry, plus one; 0 for none. */
  private final int[] top = new int[SPAN];

  /** A bit for each bucket that is not empty. */
  private final long[] filled = new long[SPAN / Long.SIZE];

  private int[] items = new int[1024];

  /** By place: the next one in its bucket, or in the list of unused ones, plus one. */
  private int[] next = new int[1024];

  private int used;
  private int unused;
  private int size;
  private int key;

  /** Empties it; the keys that come are at least this. */
  void clear(int leastKey) {
    for (int i = 0; i < filled.length; i++) {
      for (long bits = filled[i]; bits != 0; bits &= bits - 1) {
        top[i * Long.SIZE + Long.numberOfTrailingZeros(bits)] = 0;
      }
      filled[i] = 0;
    }
    used = 0;
    unused = 0;
    size = 0;
    key = leastKey;
  }

  boolean isEmpty() {
    return size == 0;
  }

  void push(int item, int itemKey) {
    int place = unused - 1;
    if (place >= 0) {
      unused = next[place];
    } else {
      place = used++;
      if (place == items.length) {
        items = Arrays.copyOf(items, 2 * place);
        next = Arrays.copyOf(next, 2 * place);
      }
    }
    int bucket = itemKey & SPAN - 1;
    items[place] = item;
    next[place] = top[bucket];
    top[bucket] = place + 1;
    filled[bucket / Long.SIZE] |= 1L << bucket;
    size++;
  }

  /**
   * Takes an item with the least key out.
   *
   * @return -1 where all keys are above the limit
   */
  int pop(int limit) {
    if (size == 0) {
      return -1;
    }
    int bucket = key & SPAN - 1;
    int word = bucket / Long.SIZE;
    long bits = filled[word] & -1L << bucket;
    while (bits == 0) {
      word = word + 1 & filled.length - 1;
      bits = filled[word];
    }
    int least = word * Long.SIZE + Long.numberOfTrailingZeros(bits);
    int above = least - bucket & SPAN - 1;
    if (above > limit - key) {
      return -1;
    }
    key += above;
    size--;
    return take(least);
  }

  private int take(int bucket) {
    int place = top[bucket] - 1;
    top[bucket] = next[place];
    if (top[bucket] == 0) {
      filled[bucket / Long.SIZE] &= ~(1L << bucket);
    }
    next[place] = unused;
    unused = place + 1;
    return items[place];
  }

  /** The key of the item that was popped last. */
  int key() {
    return key;
  }
}
