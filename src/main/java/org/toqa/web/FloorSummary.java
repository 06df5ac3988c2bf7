package org.toqa.web;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.fleet.TaskView;
import org.toqa.grid.FloorMap;
import org.toqa.mission.TaskState;

/**
 * A floor as lists show it.
 *
 * @param robots how many belong to it
 * @param openTasks how many of its tasks have not ended
 */
public record FloorSummary(String name, String site, State state, int robots, int openTasks) {
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
    return services.fleet().floors().stream().map(floor -> of(floor, services)).toList();
  }

  public static Optional<FloorSummary> of(Services services, String name) {
    return all(services).stream().filter(floor -> floor.name().equals(name)).findFirst();
  }

  public static FloorSummary of(FloorMap floor, Services services) {
    Fleet fleet = services.fleet();
    String name = floor.name();
    Optional<FleetSnapshot> now = fleet.snapshots(name).map(SnapshotFeed::latest);
    return new FloorSummary(
        name,
        services.site().name(),
        state(name, now, fleet),
        now.map(snapshot -> snapshot.robots().size()).orElse(0),
        now.map(FloorSummary::openTasks).orElse(0));
  }

  private static State state(String name, Optional<FleetSnapshot> now, Fleet fleet) {
    if (!fleet.failures(name).isEmpty()) {
      return State.FAILED;
    }
    boolean isHeld =
        now.stream()
            .flatMap(snapshot -> snapshot.floors().stream())
            .anyMatch(view -> view.hold() != null);
    return isHeld ? State.HELD : State.READY;
  }

  /** Also those of the queue that the snapshot does not have. */
  private static int openTasks(FleetSnapshot snapshot) {
    List<TaskState> open =
        snapshot.tasks().stream().map(TaskView::state).filter(state -> !state.isEnded()).toList();
    int queued = Collections.frequency(open, TaskState.QUEUED);
    return open.size() - queued + Math.max(queued, snapshot.queuedCount());
  }
}
