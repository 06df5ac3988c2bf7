package org.toqa.fleet;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorDrawing;

/**
 * What a floor is to look like, which is not in force yet.
 *
 * @param floor its name
 * @param revision rises with every change of the draft and of the map
 * @param drawing what is in force, where there is no draft
 * @param user who changed it last; null where there is none
 * @param at when that was; null where there is none
 */
public record FloorDraft(
    String floor,
    long revision,
    FloorDrawing drawing,
    @Nullable String user,
    @Nullable Instant at) {

  /** Whether there is one. */
  public boolean isDraft() {
    return user != null;
  }
}
