package org.toqa.lab.record;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A run that is kept.
 *
 * @param user who ordered it
 * @param startedAt null: it has not begun
 * @param endedAt null: it is not over
 * @param detail why it failed, in English; null: it has not
 */
public record LabRun(
    long id,
    LabOrder order,
    String user,
    Instant orderedAt,
    @Nullable Instant startedAt,
    @Nullable Instant endedAt,
    LabRunState state,
    @Nullable String detail) {}
