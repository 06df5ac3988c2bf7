package org.toqa.fleet.history;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.LoadView;
import org.toqa.geometry.Polyline;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask.LoadSize;

/**
 * Where a load was for a time.
 *
 * @param load which one, by the first task that had it
 * @param task that it was ordered for, or that left it there
 * @param from when that began
 * @param until the first moment after it; null: it still is
 * @param position metres, map frame, to the millimetre; null: on its robots
 * @param robots that carried it, the leader first
 * @param size null: nobody said
 */
public record LoadPlace(
    long load,
    long task,
    String floor,
    Instant from,
    @Nullable Instant until,
    @Nullable Vec2 position,
    List<String> robots,
    @Nullable LoadSize size) {

  public LoadPlace {
    robots = List.copyOf(robots);
  }

  static LoadPlace of(LoadView view, Instant from) {
    TaskPlace place = view.place();
    return new LoadPlace(
        view.id(),
        view.task(),
        view.floor(),
        from,
        null,
        place == null ? null : Polyline.toMillimetres(place.position()),
        view.robots(),
        view.size());
  }

  LoadPlace endedAt(Instant end) {
    return new LoadPlace(load, task, floor, from, end, position, robots, size);
  }

  /** Whether the other tells the same of another time. */
  boolean isLike(LoadPlace other) {
    return load == other.load
        && task == other.task
        && floor.equals(other.floor)
        && Objects.equals(position, other.position)
        && robots.equals(other.robots)
        && Objects.equals(size, other.size);
  }
}
