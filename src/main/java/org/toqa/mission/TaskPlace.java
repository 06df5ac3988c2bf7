package org.toqa.mission;

import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Where a task starts or ends.
 *
 * @param position metres, map frame
 * @param station the station's name, where it was given by name
 */
public record TaskPlace(Vec2 position, @Nullable String station) {

  /** For people: the station's name, or the coordinates. */
  public String text() {
    return station != null
        ? station
        : String.format(Locale.ROOT, "(%.2f, %.2f)", position.x(), position.y());
  }
}
