package org.toqa.grid;

/**
 * What is kept from walls and obstacles beyond the size of who drives (Tanta, "Map and planner":
 * margins 1 and 2), metres, 0 or more.
 *
 * @param robot by a robot alone, where there is room for it and the path is not much longer
 * @param formation by a formation, at least {@link #LEAST}; no more than that where it sets out, if
 *     need be
 */
public record Margins(double robot, double formation) {
  /** What a formation keeps even where it may need all the room that there is. */
  public static final double LEAST = 0.005;

  /**
   * A robot alone keeps what it may be beside its path before it stands; the footprint of a
   * formation has that for each member already, so it keeps what maps and places are rounded by.
   */
  public static final Margins USUAL = new Margins(0.05, 0.02);

  public Margins {
    if (!(robot >= 0 && formation >= LEAST)) {
      throw new IllegalArgumentException("margins of " + robot + " and " + formation);
    }
  }
}
