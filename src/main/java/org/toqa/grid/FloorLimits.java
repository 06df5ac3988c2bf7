package org.toqa.grid;

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

  /** Whether a place may be called so. */
  public static boolean isName(String name) {
    return !name.isBlank()
        && name.codePointCount(0, name.length()) <= LONGEST_NAME
        && name.chars().noneMatch(Character::isISOControl);
  }
}
