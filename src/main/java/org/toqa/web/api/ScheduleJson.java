package org.toqa.web.api;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TemplateUse;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskKind;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.input.TemplateFiller;
import tools.jackson.databind.JsonNode;

/**
 * A schedule on the wire: with {@code at}, with {@code from} and {@code everyMinutes}, or with
 * {@code weekdays}, {@code time} and {@code zone}.
 *
 * @param template from which its task was made; null: from none
 * @param values of the template's parameters
 */
record ScheduleJson(
    long id,
    OrderJson task,
    @Nullable Instant at,
    @Nullable Instant from,
    @Nullable Long everyMinutes,
    @Nullable List<DayOfWeek> weekdays,
    @Nullable String time,
    @Nullable String zone,
    @Nullable Instant until,
    boolean paused,
    boolean resting,
    @Nullable Instant due,
    @Nullable Long lastTask,
    String user,
    Instant createdAt,
    @Nullable String template,
    @Nullable JsonNode values) {

  /** Either a station, or metres in the map frame. */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  record WhereJson(@Nullable String station, @Nullable Double x, @Nullable Double y) {
    static WhereJson of(Where where) {
      return switch (where) {
        case Where.Station(String name) -> new WhereJson(name, null, null);
        case Where.Point(var position) -> new WhereJson(null, position.x(), position.y());
        case Where.Charger _ -> new WhereJson(null, null, null); // its stop says which
      };
    }
  }

  /** A stop as it was ordered. */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  record StopJson(
      @Nullable String station,
      @Nullable Double x,
      @Nullable Double y,
      boolean waitForPerson,
      @Nullable Long waitSeconds,
      Stop.@Nullable Charge charge) {
    static StopJson of(StopOrder stop) {
      WhereJson where = WhereJson.of(stop.where());
      Duration wait = stop.waitTime();
      return new StopJson(
          where.station(),
          where.x(),
          where.y(),
          stop.awaitsPerson(),
          wait == null ? null : Long.valueOf(wait.toSeconds()),
          stop.charge());
    }
  }

  record OrderJson(
      String name,
      TaskKind kind,
      double load,
      WhereJson start,
      WhereJson goal,
      @Nullable String floor,
      int priority,
      @Nullable LoadSize size,
      List<String> onlyRobots,
      List<StopJson> stops) {
    static OrderJson of(TaskOrder order) {
      return new OrderJson(
          order.name(),
          order.kind(),
          order.load(),
          WhereJson.of(order.start()),
          WhereJson.of(order.goal()),
          order.floor(),
          order.priority(),
          order.size(),
          order.onlyRobots(),
          order.stops().stream().map(StopJson::of).toList());
    }
  }

  static ScheduleJson of(Schedule schedule) {
    return switch (schedule.recurrence()) {
      case Recurrence.Once(Instant at) -> of(schedule, at, null, null, null, null, null);
      case Recurrence.Every(Instant first, Duration pause) ->
          of(schedule, null, first, pause.toMinutes(), null, null, null);
      case Recurrence.Weekly(var days, LocalTime time, ZoneId zone) ->
          of(
              schedule,
              null,
              null,
              null,
              days.stream().sorted().toList(),
              time.toString(),
              zone.getId());
    };
  }

  private static ScheduleJson of(
      Schedule schedule,
      @Nullable Instant at,
      @Nullable Instant from,
      @Nullable Long everyMinutes,
      @Nullable List<DayOfWeek> weekdays,
      @Nullable String time,
      @Nullable String zone) {
    TemplateUse template = schedule.template();
    return new ScheduleJson(
        schedule.id(),
        OrderJson.of(schedule.order()),
        at,
        from,
        everyMinutes,
        weekdays,
        time,
        zone,
        schedule.until(),
        schedule.paused(),
        schedule.resting(),
        schedule.due(),
        schedule.lastTask(),
        schedule.user(),
        schedule.createdAt(),
        template == null ? null : template.name(),
        template == null ? null : TemplateFiller.object(template.values()));
  }
}
