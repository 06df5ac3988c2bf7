package org.toqa.web.input;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.TaskOrder;

/**
 * The order of a schedule.
 *
 * @param order of each of its tasks
 * @param until the last moment; null: it has no end
 */
public record ScheduleOrder(TaskOrder order, Recurrence recurrence, @Nullable Instant until) {}
