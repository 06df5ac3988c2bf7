package org.toqa.allocation;

import java.util.List;
import java.util.stream.Stream;
import org.toqa.geometry.Vec2;

/**
 * A place where robots fetch or set down a load now, or soon will.
 *
 * @param place metres, map frame
 * @param together whether several robots carry the load, who need the place for themselves
 */
public record PlaceUse(long task, Vec2 place, boolean together) {
  /** Metres round a place that robots need that are round a load there. */
  public static final double REACH = 1.2;

  /** The places of a task that has robots. */
  static List<PlaceUse> of(AllocationTask task, boolean together) {
    return Stream.of(Stream.of(task.start()), task.via().stream(), Stream.of(task.goal()))
        .flatMap(places -> places)
        .map(place -> new PlaceUse(task.id(), place, together))
        .toList();
  }
}
