package org.toqa.forecast;

import java.util.List;
import java.util.OptionalLong;
import org.jspecify.annotations.Nullable;

/** A task that is not delivered yet, as a forecast sees it. */
public sealed interface ForecastTask {
  long id();

  /** Where it still has to come, the first one first; at least one. */
  List<Visit> visits();

  /** Why no time can be said, whatever the robots do; null: it can. */
  @Nullable Unknown unknown();

  /**
   * One that has robots.
   *
   * @param isFetched whether its load is on board; else the first visit is where it is picked up
   * @param load kilograms
   * @param robots names, the leader first
   * @param underway what its leader still drives to the first visit, on the path that it has
   */
  record Begun(
      long id,
      double load,
      List<Visit> visits,
      boolean isFetched,
      List<String> robots,
      Drive underway,
      @Nullable Unknown unknown)
      implements ForecastTask {
    public Begun {
      visits = List.copyOf(visits);
      robots = List.copyOf(robots);
    }
  }

  /**
   * One that waits for robots; it is picked up at its first visit.
   *
   * @param load kilograms
   * @param onlyRobots names of those that may carry it; empty: whichever there are
   * @param isForOne whether several may not carry it together
   * @param after the task that must be delivered before it begins
   * @param waited for how long it has waited, seconds, with what its priority is worth
   */
  record Queued(
      long id,
      double load,
      List<Visit> visits,
      List<String> onlyRobots,
      boolean isForOne,
      OptionalLong after,
      double waited,
      @Nullable Unknown unknown)
      implements ForecastTask {
    public Queued {
      visits = List.copyOf(visits);
      onlyRobots = List.copyOf(onlyRobots);
    }

    boolean allows(String robot) {
      return onlyRobots.isEmpty() || onlyRobots.contains(robot);
    }
  }
}
