package org.toqa.web.input;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TemplateUse;

/**
 * The order of a schedule.
 *
 * @param order of each of its tasks
 * @param template what the order was made from; null: from no template
 * @param until the last moment; null: it has no end
 */
public record ScheduleOrder(
    TaskOrder order,
    @Nullable TemplateUse template,
    Recurrence recurrence,
    @Nullable Instant until) {}
