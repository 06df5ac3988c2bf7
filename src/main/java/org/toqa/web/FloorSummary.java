package org.toqa.web;

import java.util.List;
import java.util.Optional;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.grid.FloorMap;

/**
 * A floor as lists show it.
 *
 * @param robots how many belong to it
 * @param openTasks how many of its tasks have not ended
 */
public record FloorSummary(String name, String site, State state, int robots, int openTasks) {
  /** What the first site is called. */
  private static final String FIRST_SITE = "main";

  /** Whether its robots drive. */
  public enum State {
    READY,
    /** By an operator, all its robots. */
    HELD,
    /** It cannot go on by itself. */
    FAILED
  }

  /** All floors, the first one the default. */
  public static List<FloorSummary> all(Services services) {
    FleetSnapshot now = services.fleet().snapshots().latest();
    return services.fleet().floors().stream().map(floor -> of(floor, now)).toList();
  }

  public static Optional<FloorSummary> of(Services services, String name) {
    return all(services).stream().filter(floor -> floor.name().equals(name)).findFirst();
  }

  public static FloorSummary of(FloorMap floor, FleetSnapshot now) {
    String name = floor.name();
    boolean isHeld =
        now.floors().stream().anyMatch(view -> view.name().equals(name) && view.hold() != null);
    return new FloorSummary(
        name,
        FIRST_SITE,
        isHeld ? State.HELD : State.READY,
        (int) now.robots().stream().filter(robot -> robot.floor().equals(name)).count(),
        (int)
            now.tasks().stream()
                .filter(task -> task.task().floor().equals(name) && !task.state().isEnded())
                .count());
  }
}
