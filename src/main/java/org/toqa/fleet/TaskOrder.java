package org.toqa.fleet;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;

/**
 * An order for a transport task, as a form or the API brings it. The fleet checks it against the
 * floor and the robots; the web has checked only its shape.
 *
 * @param load kilograms
 * @param floor null: the one of {@link FloorChoice}
 * @param onlyRobots names of those that may carry it; empty: whichever there are
 */
public record TaskOrder(
    String name,
    double load,
    Where start,
    Where goal,
    @Nullable String floor,
    int priority,
    @Nullable Instant deadline,
    @Nullable LoadSize size,
    List<String> onlyRobots) {

  /** As many names a task may have. */
  public static final int MAX_ONLY_ROBOTS = 20;

  public TaskOrder {
    onlyRobots = List.copyOf(onlyRobots);
  }

  /** One that any robot may carry. */
  public TaskOrder(
      String name,
      double load,
      Where start,
      Where goal,
      @Nullable String floor,
      int priority,
      @Nullable Instant deadline,
      @Nullable LoadSize size) {
    this(name, load, start, goal, floor, priority, deadline, size, List.of());
  }

  /**
   * The task that is ordered; its id is not known yet.
   *
   * @param from what {@code start} is on that floor
   * @param to what {@code goal} is there
   */
  public TransportTask task(
      TaskPlace from, TaskPlace to, String resolvedFloor, String user, Instant now) {
    return new TransportTask(
            0, name, load, from, to, resolvedFloor, priority, deadline, size, user, now)
        .withOnlyRobots(onlyRobots);
  }

  /** The same from there to there. */
  public TaskOrder between(Where from, Where to) {
    return new TaskOrder(name, load, from, to, floor, priority, deadline, size, onlyRobots);
  }

  /** A place by its coordinates or by its station's name. */
  public sealed interface Where {
    record Point(Vec2 position) implements Where {}

    record Station(String name) implements Where {}

    private boolean isAt(TaskPlace place) {
      return switch (this) {
        case Station(String name) -> name.equals(place.station());
        case Point(Vec2 position) -> place.station() == null && position.equals(place.position());
      };
    }
  }

  /** Whether the task is what this orders, but for the priority, which may have changed since. */
  public boolean isOrderOf(TransportTask task) {
    return name.equals(task.name())
        && load == task.load()
        && start.isAt(task.start())
        && goal.isAt(task.goal())
        && (floor == null || floor.equals(task.floor()))
        && Objects.equals(asStored(deadline), asStored(task.deadline()))
        && Objects.equals(size, task.size())
        && onlyRobots.equals(task.onlyRobots());
  }

  /** As far as the store keeps it. */
  private static @Nullable Instant asStored(@Nullable Instant moment) {
    return moment == null ? null : moment.truncatedTo(ChronoUnit.MILLIS);
  }
}
