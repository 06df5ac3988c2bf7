package org.toqa.traffic;

import java.util.List;

/**
 * The next steps of one robot.
 *
 * @param stances from the present one on, a step apart
 */
public record Itinerary(List<Stance> stances, Prospect prospect) {
  public Itinerary {
    stances = List.copyOf(stances);
  }

  /** The stance after so many steps; the last one from there on. */
  public Stance at(int step) {
    return stances.get(Math.min(step, stances.size() - 1));
  }
}
