package org.toqa.store;

import java.util.List;

/**
 * A period in numbers.
 *
 * @param series one for each bucket of the period
 * @param robots those that were recorded, by name
 */
public record PeriodFigures(
    Period period, Figures total, List<Figures> series, List<RobotFigures> robots) {
  public PeriodFigures {
    series = List.copyOf(series);
    robots = List.copyOf(robots);
  }
}
