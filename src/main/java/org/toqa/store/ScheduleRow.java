package org.toqa.store;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.jdbi.v3.core.mapper.Nested;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TemplateUse;

/**
 * A row of the table of schedules.
 *
 * @param kind ONCE, EVERY or WEEKLY; which of the next five columns are null depends on it
 * @param everyS seconds
 * @param resting whether its user is disabled, or none any more
 * @param templateId what its order was made from; null as the other columns of it: from no template
 * @param weekdays names of {@link DayOfWeek} with commas between
 */
record ScheduleRow(
    long id,
    String name,
    String userName,
    String floor,
    double loadKg,
    @Nullable Double loadLength,
    @Nullable Double loadWidth,
    @Nested("start") PlaceColumns start,
    @Nested("goal") PlaceColumns goal,
    int priority,
    String kind,
    @Nullable Instant firstAt,
    long everyS,
    @Nullable String weekdays,
    @Nullable String timeOfDay,
    @Nullable String zone,
    @Nullable Instant untilAt,
    boolean paused,
    @Nullable Long userId,
    boolean resting,
    Instant createdAt,
    @Nullable Instant dueAt,
    @Nullable Long lastTask,
    @Nullable String onlyRobots,
    @Nullable String stops,
    @Nullable Long templateId,
    @Nullable String templateName,
    @Nullable Instant templateChangedAt,
    @Nullable String templateValues) {

  Schedule toSchedule() {
    List<StopOrder> way = StopsJson.readOrder(stops);
    TaskOrder order =
        new TaskOrder(
            name,
            loadKg,
            way.isEmpty() ? start.toWhere() : way.getFirst().where(),
            way.isEmpty() ? goal.toWhere() : way.getLast().where(),
            floor,
            priority,
            null,
            TaskRow.loadSize(loadLength, loadWidth),
            RobotNames.read(onlyRobots),
            way);
    return new Schedule(
        id,
        order,
        recurrence(),
        untilAt,
        paused,
        userName,
        userId,
        resting,
        createdAt,
        dueAt,
        lastTask,
        template());
  }

  private @Nullable TemplateUse template() {
    return templateId == null
        ? null
        : new TemplateUse(
            templateId,
            Objects.requireNonNull(templateName),
            Objects.requireNonNull(templateChangedAt),
            Objects.requireNonNull(templateValues));
  }

  private Recurrence recurrence() {
    return switch (kind) {
      case "ONCE" -> new Recurrence.Once(Objects.requireNonNull(firstAt));
      case "EVERY" ->
          new Recurrence.Every(Objects.requireNonNull(firstAt), Duration.ofSeconds(everyS));
      default ->
          new Recurrence.Weekly(
              Arrays.stream(Objects.requireNonNull(weekdays).split(",", -1))
                  .map(DayOfWeek::valueOf)
                  .collect(Collectors.toSet()),
              LocalTime.parse(Objects.requireNonNull(timeOfDay)),
              ZoneId.of(Objects.requireNonNull(zone)));
    };
  }
}
