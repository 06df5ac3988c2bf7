package org.toqa.allocation;

/**
 * Which robots a team may be of, where others had no room.
 *
 * @param narrowerThan metres, of each of them
 * @param isForOmnidirectional whether all of them must be able to go sideways
 */
public record TeamLimit(double narrowerThan, boolean isForOmnidirectional) {
  /** Of whichever there are. */
  public static final TeamLimit NONE = new TeamLimit(Double.POSITIVE_INFINITY, false);

  boolean allows(Candidate robot) {
    return robot.diameter() < narrowerThan && (robot.isOmnidirectional() || !isForOmnidirectional);
  }
}
