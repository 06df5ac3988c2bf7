package org.toqa.planning;

import java.util.Arrays;

/** The moves of a path in order, as ordinals of {@link Heading}; its room is used again. */
final class MoveSequence {
  private byte[] headings = new byte[256];
  private int size;

  void clear() {
    size = 0;
  }

  /** The same move, so many times. */
  void add(int heading, int times) {
    if (size + times > headings.length) {
      headings = Arrays.copyOf(headings, 2 * (size + times));
    }
    Arrays.fill(headings, size, size + times, (byte) heading);
    size += times;
  }

  void reverse() {
    for (int i = 0, j = size - 1; i < j; i++, j--) {
      byte first = headings[i];
      headings[i] = headings[j];
      headings[j] = first;
    }
  }

  int size() {
    return size;
  }

  Heading get(int index) {
    return Heading.of(headings[index]);
  }
}
