package org.toqa.fleet;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;

/**
 * An order for a transport task, as a form or the API brings it. The fleet checks it against the
 * floor and the robots; the web has checked only its shape.
 *
 * @param load kilograms
 * @param floor null: the only floor, or the first
 */
public record TaskOrder(
    String name,
    double load,
    Where start,
    Where goal,
    @Nullable String floor,
    int priority,
    @Nullable Instant deadline,
    @Nullable LoadSize size) {

  /** A place by its coordinates or by its station's name. */
  public sealed interface Where {
    record Point(Vec2 position) implements Where {}

    record Station(String name) implements Where {}
  }
}
