package org.toqa.planning;

import java.util.Arrays;

/**
 * A* over (cell, heading in which the cell was entered). A move keeps the heading or changes it by
 * 45 degrees, which the robot drives as an arc; a larger change is a turn on the spot, where it is
 * allowed at all.
 *
 * <p>The lower bound for the rest of the path is the exact octile distance, found on demand by an
 * {@link OctileSearch} from the goal: it drops only the rule about headings, so few states beyond
 * the best paths are looked at (as the reverse resumable A* of Silver, "Cooperative pathfinding",
 * 2005; A*: Hart, Nilsson and Raphael, 1968). With a bound that exact and consistent a state is
 * final when it is first popped, and what it costs follows from its key: no costs are kept.
 *
 * <p>The search goes on in levels. At each one only states up to a length are looked at, and a
 * state in a cell by which no octile path is that short waits for the next level: so the search for
 * the bounds looks no farther than it has to. What it finds depends on exact distances alone, not
 * on how many of them were known before.
 *
 * <p>8 B a cell. Confined to one thread.
 */
final class HeadingSearch {
  private static final int EXPANSIONS_A_CHECK = 1024;

  /** From one level to the next. */
  private static final int LEVEL = MoveCost.STRAIGHT;

  /** A turn in an entry or a state is stored from 1 to 8: from -3 to 4 eighths. */
  private static final int TURN_BITS = 3;

  private static final int LARGEST_RIGHT_TURN = 3;

  /**
   * By cell: a bit a heading that is final, and above these three bits each of how it was entered.
   */
  private int[] states = {};

  /** Whether a cell's states belong to this search. */
  private int[] stamp = {};

  /** Of {@code 64 cell + 8 heading + turn}. */
  private final BucketQueue open = new BucketQueue();

  /** Entries that wait for the next level, and their lengths. */
  private int[] deferred = new int[1024];

  private int[] deferredLengths = new int[1024];
  private int deferredCount;

  private MoveGraph graph;
  private final OctileSearch toGoal;
  private int generation;
  private long expandedCount;

  private int startColumn;
  private int startRow;

  /** The largest change of heading, in eighths of a turn. */
  private int largestTurn;

  /** The longest path of this level. */
  private int level;

  HeadingSearch(MoveGraph graph, OctileSearch toGoal) {
    this.graph = graph;
    this.toGoal = toGoal;
  }

  /**
   * Finds a shortest path; {@link OctileSearch#begin} was called with the goal as its source.
   *
   * @param start not the goal
   * @param shortest the octile distance between the two
   * @param turnsOnSpot whether the robot may also turn on the spot
   * @param moves is given the path's moves
   * @return whether there is one
   */
  boolean search(
      MoveGraph moveGraph,
      int start,
      int goal,
      int shortest,
      boolean turnsOnSpot,
      MoveSequence moves) {
    begin(moveGraph, start, shortest, turnsOnSpot);
    while (!open.isEmpty() || deferredCount > 0) {
      for (int entry = open.pop(level); entry >= 0; entry = open.pop(level)) {
        int state = entry >> TURN_BITS;
        int cell = state >> 3;
        int bit = 1 << (state & 7);
        if ((states[cell] & bit) == 0) {
          states[cell] |= bit | (entry & 7) << turnShift(state & 7);
          if (cell == goal) {
            findMoves(state, start, moves);
            return true;
          }
          expand(state);
        }
      }
      level += LEVEL;
      reachDeferred();
    }
    return false;
  }

  private void begin(MoveGraph moveGraph, int start, int shortest, boolean turnsOnSpot) {
    graph = moveGraph;
    if (stamp.length < graph.size()) {
      states = new int[graph.size()];
      stamp = new int[graph.size()];
      generation = 0;
    }
    if (generation == Integer.MAX_VALUE) {
      generation = 0;
      Arrays.fill(stamp, 0);
    }
    generation++;
    startColumn = graph.column(start);
    startRow = graph.row(start);
    largestTurn = turnsOnSpot ? 4 : 1;
    level = shortest;
    deferredCount = 0;
    open.clear(shortest);
    touch(start);
    for (int heading = 0; heading < 8; heading++) {
      reach(entry(start, heading, 0), 0);
    }
  }

  /** How many states were ever expanded. */
  long expandedCount() {
    return expandedCount;
  }

  private static int entry(int cell, int heading, int turn) {
    return (cell << 3 | heading) << TURN_BITS | turn + LARGEST_RIGHT_TURN;
  }

  private void expand(int state) {
    expandedCount++;
    if (expandedCount % EXPANSIONS_A_CHECK == 0) {
      SearchLimit.check();
    }
    int cell = state >> 3;
    int moves = graph.moves(cell);
    int length = open.key() - toGoal.distance(cell);
    for (int size = largestTurn; size > 0; size--) {
      reach(state, moves, -size, length);
      reach(state, moves, size, length);
    }
    reach(state, moves, 0, length); // the last one is popped first: rather straight
  }

  private void reach(int state, int moves, int turn, int length) {
    int heading = state + turn & 7;
    if ((moves >> heading & 1) == 1 && turn >= -LARGEST_RIGHT_TURN) {
      int next = graph.target(state >> 3, heading);
      touch(next);
      if ((states[next] >> heading & 1) == 0) {
        reach(entry(next, heading, turn), length + cost(turn, heading));
      }
    }
  }

  /** Puts it on the open list if a path by its cell can be short enough for this level. */
  private void reach(int entry, int length) {
    int cell = entry >> (3 + TURN_BITS);
    int ahead = toGoal.distanceWithin(cell, level - octileToStart(cell));
    if (ahead != OctileSearch.UNREACHABLE) {
      open.push(entry, length + ahead);
    } else if (!toGoal.isCutOff(cell)) {
      defer(entry, length);
    }
  }

  private void defer(int entry, int length) {
    if (deferredCount == deferred.length) {
      deferred = Arrays.copyOf(deferred, 2 * deferredCount);
      deferredLengths = Arrays.copyOf(deferredLengths, 2 * deferredCount);
    }
    deferred[deferredCount] = entry;
    deferredLengths[deferredCount++] = length;
  }

  private void reachDeferred() {
    int waiting = deferredCount;
    deferredCount = 0;
    for (int i = 0; i < waiting; i++) {
      int state = deferred[i] >> TURN_BITS;
      if ((states[state >> 3] >> (state & 7) & 1) == 0) {
        reach(deferred[i], deferredLengths[i]);
      }
    }
  }

  private int octileToStart(int cell) {
    return MoveCost.octile(graph.column(cell) - startColumn, graph.row(cell) - startRow);
  }

  private void touch(int cell) {
    if (stamp[cell] != generation) {
      stamp[cell] = generation;
      states[cell] = 0;
    }
  }

  /** A move after a change of heading by so many eighths of a turn. */
  private static int cost(int turn, int heading) {
    int eighthsOnSpot = Math.abs(turn) <= 1 ? 0 : Math.abs(turn);
    return eighthsOnSpot * MoveCost.EIGHTH_TURN + MoveGraph.cost(heading);
  }

  private static int turnShift(int heading) {
    return 8 + TURN_BITS * heading;
  }

  /** Back along the turns; at the start all headings cost nothing, so a path ends there. */
  private void findMoves(int goalState, int start, MoveSequence moves) {
    moves.clear();
    int state = goalState;
    while (state >> 3 != start) {
      int heading = state & 7;
      moves.add(heading, 1);
      int turn = (states[state >> 3] >>> turnShift(heading) & 7) - LARGEST_RIGHT_TURN;
      int cell = graph.target(state >> 3, heading + 4 & 7);
      state = 8 * cell + (heading - turn & 7);
    }
    moves.reverse();
  }
}
