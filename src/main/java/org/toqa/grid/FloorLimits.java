package org.toqa.grid;

import org.toqa.text.GivenName;

/** What may be said of a floor. */
public final class FloorLimits {
  /** Letters, of floors and their places. */
  public static final int LONGEST_NAME = 64;

  /** Metres a second, of {@link SpeedLimit}. */
  public static final double SLOWEST = 0.05;

  /** Metres a second. */
  public static final double FASTEST = 3;

  /** Of each kind of places and areas. */
  public static final int MOST_OF_A_KIND = 1000;

  private FloorLimits() {}

  /** Whether a floor may be called so, which stands in addresses and tables. */
  public static boolean isFloorName(String name) {
    return isName(name)
        && name.length() <= LONGEST_NAME // as wide as the columns
        && name.equals(name.strip())
        && name.chars().noneMatch(letter -> letter == '/' || letter == '\\')
        && !name.equals(".")
        && !name.equals("..");
  }

  /** Whether a place may be called so. */
  public static boolean isName(String name) {
    return GivenName.isName(name, LONGEST_NAME);
  }
}
