package org.toqa.fleet;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorDrawing;

/**
 * What a floor is to look like, which is not in force yet.
 *
 * @param floor its name
 * @param revision rises with every change of the draft; 0: there is none, and the drawing is what
 *     is in force
 * @param user who changed it last; null where there is none
 * @param at when that was; null where there is none
 */
public record FloorDraft(
    String floor,
    long revision,
    FloorDrawing drawing,
    @Nullable String user,
    @Nullable Instant at) {}
