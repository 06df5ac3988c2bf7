package org.toqa.planning;

/**
 * Lengths as integers, so that sums are exact and ties are real ties. A unit is 1/408 cell: 577/408
 * is a convergent of sqrt 2, and no fraction with a smaller denominator lies between the two. Two
 * paths that differ by fewer than 408 diagonal moves are therefore compared as with sqrt 2 itself;
 * beyond that the error stays under 2 parts in a million.
 */
final class MoveCost {
  static final int STRAIGHT = 408;
  static final int DIAGONAL = 577;

  /** Turning 45 degrees on the spot: 90 degrees cost as much as one cell. */
  static final int EIGHTH_TURN = STRAIGHT / 2;

  private MoveCost() {}

  /** Shortest octile path on an empty grid: admissible and consistent. */
  static int octile(int dColumn, int dRow) {
    int longer = Math.max(Math.abs(dColumn), Math.abs(dRow));
    int shorter = Math.min(Math.abs(dColumn), Math.abs(dRow));
    return (longer - shorter) * STRAIGHT + shorter * DIAGONAL;
  }
}
