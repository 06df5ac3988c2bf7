package org.toqa.mission;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/**
 * Where a task starts or ends.
 *
 * @param position metres, map frame
 * @param station the station's name, where it was given by name
 */
public record TaskPlace(Vec2 position, @Nullable String station) {

  /** For people: the station's name, or the coordinates. */
  public String text() {
    return sentence().english();
  }

  /** The same, in the reader's language. */
  public Sentence sentence() {
    return station != null ? Sentence.verbatim(station) : Sentence.of(position);
  }
}
