package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;

import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * When each vertex is taken and each edge is driven: a bit a step, so that the free times of a
 * vertex are found 64 at once. A robot that has arrived takes its goal for ever.
 *
 * <p>A path is the vertices at the times 0, 1, 2 ... up to the arrival.
 */
public class ReservationTable {
  private static final int WORD = 6;

  private final RoadGraph roads;
  private final int words;
  private final long[] vertexTaken;
  private final long[] edgeTaken;

  /**
   * An empty table.
   *
   * @param steps how far the table reaches, at least
   */
  public ReservationTable(RoadGraph roads, int steps) {
    this.roads = roads;
    this.words = (steps >> WORD) + 1;
    this.vertexTaken = new long[roads.vertexCount() * words];
    this.edgeTaken = new long[roads.vertexCount() * DIRECTIONS * words];
  }

  /** An empty table for vertices of which some cannot be taken at once. */
  static ReservationTable of(RoadGraph roads, Spacing spacing, int steps) {
    return spacing.isNone()
        ? new ReservationTable(roads, steps)
        : new SpacedReservations(roads, spacing, steps);
  }

  /** The first step that is beyond the table; means "for ever". */
  public int end() {
    return words << WORD;
  }

  public void add(int[] path) {
    for (int t = 0; t < path.length; t++) {
      vertexTaken[word(path[t], t)] |= 1L << t;
      if (t > 0 && path[t] != path[t - 1]) {
        edgeTaken[edgeWord(path[t - 1], roads.direction(path[t - 1], path[t]), t - 1)] |=
            1L << (t - 1);
      }
    }
    setTakenFromEnd(path, true);
  }

  public void remove(int[] path) {
    for (int t = 0; t < path.length; t++) {
      vertexTaken[word(path[t], t)] &= ~(1L << t);
      if (t > 0 && path[t] != path[t - 1]) {
        edgeTaken[edgeWord(path[t - 1], roads.direction(path[t - 1], path[t]), t - 1)] &=
            ~(1L << (t - 1));
      }
    }
    setTakenFromEnd(path, false);
  }

  private void setTakenFromEnd(int[] path, boolean isTaken) {
    int goal = path[path.length - 1];
    int base = goal * words;
    int first = path.length >> WORD;
    for (int w = first; w < words; w++) {
      long mask = w == first ? -1L << path.length : -1L;
      vertexTaken[base + w] =
          isTaken ? vertexTaken[base + w] | mask : vertexTaken[base + w] & ~mask;
    }
  }

  public boolean isTaken(int vertex, int time) {
    return (vertexTaken[word(vertex, time)] >>> time & 1) != 0;
  }

  /** Whether a path meets nobody, on its way and for ever at its goal. */
  final boolean admits(int[] path) {
    for (int t = 0; t < path.length; t++) {
      if (isTaken(path[t], t)) {
        return false;
      }
      if (t > 0 && path[t] != path[t - 1]) {
        int back = RoadGraph.opposite(roads.direction(path[t - 1], path[t]));
        if (nextFreeEdge(path[t], back, t - 1) != t - 1) {
          return false;
        }
      }
    }
    return nextTaken(path[path.length - 1], path.length - 1) == end();
  }

  /** The first time from {@code time} on at which the vertex is free, or {@link #end}. */
  int nextFree(int vertex, int time) {
    return firstBit(vertexTaken, vertex * words, time, -1L);
  }

  /** The first time from {@code time} on at which the vertex is taken, or {@link #end}. */
  int nextTaken(int vertex, int time) {
    return firstBit(vertexTaken, vertex * words, time, 0L);
  }

  /**
   * The first time from {@code time} on at which nobody drives from the vertex in that direction.
   */
  int nextFreeEdge(int vertex, int direction, int time) {
    return firstBit(edgeTaken, (vertex * DIRECTIONS + direction) * words, time, -1L);
  }

  /** Since when the vertex has been free at {@code time}. */
  int freeSince(int vertex, int time) {
    int w = time >> WORD;
    long bits = vertexTaken[vertex * words + w] & ((1L << time) - 1);
    while (bits == 0) {
      if (w == 0) {
        return 0;
      }
      bits = vertexTaken[vertex * words + --w];
    }
    return (w << WORD) + Long.SIZE - Long.numberOfLeadingZeros(bits);
  }

  /** The vertex beside one in a direction, from which one comes to it. */
  final int beside(int vertex, int direction) {
    return roads.predecessor(vertex, direction);
  }

  private int firstBit(long[] table, int base, int time, long flipped) {
    if (time >= end()) {
      return end();
    }
    int w = time >> WORD;
    long bits = (table[base + w] ^ flipped) & (-1L << time);
    while (bits == 0) {
      if (++w == words) {
        return end();
      }
      bits = table[base + w] ^ flipped;
    }
    return (w << WORD) + Long.numberOfTrailingZeros(bits);
  }

  private int word(int vertex, int time) {
    return vertex * words + (time >> WORD);
  }

  private int edgeWord(int vertex, int direction, int time) {
    return (vertex * DIRECTIONS + direction) * words + (time >> WORD);
  }
}
