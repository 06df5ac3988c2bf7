package org.toqa.planning;

/**
 * Orders the moves of a path over jump points so that no bend is larger than 45 degrees, where that
 * can be done from one jump point to the next. The path keeps its length; that is the shortest for
 * any moves at all, so no path with such bends is shorter.
 *
 * <p>The moves of a piece between two jump points are diagonal ones in one direction and straight
 * ones in another, 45 degrees apart. Of the orders in which they bend at most twice, some are
 * tried: a few of one kind, all of the other, the rest of the first. One with the fewest bends is
 * found piece by piece, for either heading in which a piece may end (dynamic programming); a
 * piece's cells are looked at only for an order that would be better. Confined to one thread.
 */
final class PieceOrder {
  private static final int NONE = Integer.MAX_VALUE;

  private final JumpPoints path;

  /** Two values a piece: the bends up to its end, if its last move is diagonal, and if straight. */
  private int[] bends = new int[128];

  /** For these: {@code 4 leading + 2 kind of the first move + kind of the last move before}. */
  private int[] orders = new int[128];

  private MoveGraph graph;

  // the piece that is looked at
  private int piece;

  /** By kind, diagonal first: the heading, and how many moves there are. */
  private final int[] headings = new int[2];

  private final int[] counts = new int[2];

  /** The headings of the piece before, by kind. */
  private final int[] headingsBefore = new int[2];

  PieceOrder(MoveGraph graph, JumpPoints path) {
    this.graph = graph;
    this.path = path;
  }

  /**
   * Orders the path that was found last.
   *
   * @param moves is given its moves
   * @return false: there is no such order among those that are tried
   */
  boolean order(MoveGraph moveGraph, MoveSequence moves) {
    graph = moveGraph;
    int pieces = path.pieceCount();
    if (bends.length < 2 * pieces) {
      bends = new int[4 * pieces];
      orders = new int[4 * pieces];
    }
    for (int i = 0; i < pieces; i++) {
      lookAt(i);
      tryOrders();
      if (fewest(i) == NONE) {
        return false;
      }
      headingsBefore[0] = headings[0];
      headingsBefore[1] = headings[1];
    }
    addMoves(pieces, moves);
    return true;
  }

  private int fewest(int ofPiece) {
    return Math.min(bends[2 * ofPiece], bends[2 * ofPiece + 1]);
  }

  private void lookAt(int which) {
    piece = which;
    int from = path.pieceStart(which);
    int to = path.pieceEnd(which);
    int columns = graph.column(to) - graph.column(from);
    int rows = graph.row(to) - graph.row(from);
    counts[0] = Math.min(Math.abs(columns), Math.abs(rows));
    counts[1] = Math.max(Math.abs(columns), Math.abs(rows)) - counts[0];
    headings[0] = Heading.of(Integer.signum(columns), Integer.signum(rows)).ordinal();
    headings[1] =
        Math.abs(columns) > Math.abs(rows)
            ? Heading.of(Integer.signum(columns), 0).ordinal()
            : Heading.of(0, Integer.signum(rows)).ordinal();
  }

  private void tryOrders() {
    bends[2 * piece] = NONE;
    bends[2 * piece + 1] = NONE;
    for (int first = 0; first < 2; first++) {
      int count = counts[first];
      if (count == 0) {
        continue;
      }
      tryOrder(first, count);
      if (count > 1 && counts[1 - first] > 0) {
        tryOrder(first, count - 1);
        tryOrder(first, 1);
      }
    }
  }

  /**
   * @param first the kind of the first move
   * @param leading so many of this kind come before the others
   */
  private void tryOrder(int first, int leading) {
    boolean isOneKind = counts[1 - first] == 0;
    int last = isOneKind || leading < counts[first] ? first : 1 - first;
    int own = isOneKind ? 0 : leading < counts[first] ? 2 : 1;
    int best = bends[2 * piece + last];
    int order = -1;
    for (int before = 0; before < (piece == 0 ? 1 : 2); before++) {
      int until = bendsUntil(before, headings[first]);
      if (until != NONE && until + own < best) {
        best = until + own;
        order = 4 * leading + 2 * first + before;
      }
    }
    if (order >= 0 && isFree(first, leading)) {
      bends[2 * piece + last] = best;
      orders[2 * piece + last] = order;
    }
  }

  /** With a bend, if any, into the piece. */
  private int bendsUntil(int lastBefore, int heading) {
    if (piece == 0) {
      return 0;
    }
    int until = bends[2 * (piece - 1) + lastBefore];
    int apart = headingsBefore[lastBefore] - heading & 7;
    return until == NONE || (apart > 1 && apart < 7) ? NONE : until + (apart & 1);
  }

  private boolean isFree(int first, int leading) {
    if (first == 0 && leading == counts[0]) {
      return true; // as it was found
    }
    int cell = run(path.pieceStart(piece), headings[first], leading);
    cell = run(cell, headings[1 - first], counts[1 - first]);
    return run(cell, headings[first], counts[first] - leading) >= 0;
  }

  /** Where so many moves lead, -1 if one of them is not free, or the cell is none. */
  private int run(int from, int heading, int times) {
    int cell = from;
    for (int i = 0; i < times && cell >= 0; i++) {
      cell = graph.allows(cell, heading) ? graph.target(cell, heading) : -1;
    }
    return cell;
  }

  private void addMoves(int pieces, MoveSequence moves) {
    int last = bends[2 * pieces - 2] <= bends[2 * pieces - 1] ? 0 : 1;
    for (int i = pieces - 1; i >= 0; i--) { // from here on, the order of a piece is at 2 i
      int order = orders[2 * i + last];
      orders[2 * i] = order;
      last = order & 1;
    }
    moves.clear();
    for (int i = 0; i < pieces; i++) {
      lookAt(i);
      int first = orders[2 * i] >> 1 & 1;
      int leading = orders[2 * i] >> 2;
      moves.add(headings[first], leading);
      moves.add(headings[1 - first], counts[1 - first]);
      moves.add(headings[first], counts[first] - leading);
    }
  }
}
