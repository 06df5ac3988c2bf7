package org.toqa.fleet;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * One line of what happened, as it was stored.
 *
 * @param kind a short word for its sort, such as the task state that was reached
 * @param task the task it belongs to, if any
 * @param robot the robot it belongs to, if any
 * @param who the user or the part of the fleet that caused it
 * @param text a sentence for people
 */
public record EventRecord(
    Instant at,
    String kind,
    @Nullable Long task,
    @Nullable String robot,
    String who,
    String text) {}
