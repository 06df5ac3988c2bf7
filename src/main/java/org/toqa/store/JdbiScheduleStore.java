package org.toqa.store;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.result.ResultIterable;
import org.jdbi.v3.core.statement.Query;
import org.jdbi.v3.core.statement.Update;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TemplateUse;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.wording.Phrase;

/** The schedules on H2 and on MySQL. */
public final class JdbiScheduleStore implements ScheduleStore {
  private static final String SELECT =
      """
      select s.id, s.name, s.user_name, s.user_id, coalesce(u.disabled, true) as resting, s.floor, load_kg,
        load_length, load_width, start_x, start_y, start_station, goal_x, goal_y, goal_station,
        priority, kind, first_at, every_s, weekdays, time_of_day, zone, until_at, paused,
        s.created_at, due_at, last_task, only_robots, stops, template_id, template_values,
        t.name as template_name, t.changed_at as template_changed_at
      from schedules s left join users u on u.id = s.user_id
        left join task_templates t on t.id = s.template_id
      """;

  private final SqlExecutor sql;

  public JdbiScheduleStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public List<Schedule> schedules() {
    return sql.withHandle(h -> schedules(h.createQuery(SELECT + "order by s.id")).list());
  }

  @Override
  public Optional<Schedule> schedule(long id) {
    return sql.withHandle(
        h -> schedules(h.createQuery(SELECT + "where s.id = :id").bind("id", id)).findOne());
  }

  @Override
  public Optional<Schedule> scheduleByKey(UUID key) {
    return sql.withHandle(
        h ->
            schedules(h.createQuery(SELECT + "where submission = :key").bind("key", key))
                .findOne());
  }

  @Override
  public List<Schedule> due(Instant now) {
    return sql.withHandle(
        h ->
            schedules(
                    h.createQuery(
                            SELECT + "where not paused and due_at <= :now order by due_at, s.id")
                        .bind("now", now))
                .list());
  }

  private static ResultIterable<Schedule> schedules(Query query) {
    return query.mapTo(ScheduleRow.class).map(ScheduleRow::toSchedule);
  }

  @Override
  public OptionalLong add(Schedule schedule, UUID key) {
    return sql.inTransaction(
        h -> {
          Optional<Long> before = idOf(h, key);
          if (before.isPresent()) {
            return OptionalLong.of(before.get());
          }
          if (!TemplateTable.isStill(h, schedule.template())) {
            return OptionalLong.empty();
          }
          long id = insert(h, schedule, key);
          EventTable.addAll(h, List.of(added(schedule, id)));
          return OptionalLong.of(id);
        });
  }

  private static EventRecord added(Schedule schedule, long id) {
    return new EventRecord(
        schedule.createdAt(),
        EventKind.SCHEDULE_ADDED,
        null,
        null,
        schedule.user(),
        Phrase.SCHEDULE_ADDED.with(schedule.user(), id, schedule.order().name()));
  }

  private static Optional<Long> idOf(Handle h, UUID key) {
    return h.createQuery("select id from schedules where submission = :key")
        .bind("key", key)
        .mapTo(Long.class)
        .findOne();
  }

  private static long insert(Handle h, Schedule schedule, UUID key) {
    TemplateUse template = schedule.template();
    Update update =
        h.createUpdate(
                """
                insert into schedules (submission, name, user_name, user_id, floor, load_kg, load_length,
                  load_width, start_x, start_y, start_station, goal_x, goal_y, goal_station,
                  priority, kind, first_at, every_s, weekdays, time_of_day, zone, until_at, paused,
                  created_at, due_at, only_robots, stops, template_id, template_values)
                values (:submission, :name, :user, :owner, :floor, :load, :length, :width, :startX, :startY,
                  :startStation, :goalX, :goalY, :goalStation, :priority, :kind, :first, :every,
                  :weekdays, :time, :zone, :until, :paused, :at, :due, :onlyRobots, :stops, :template,
                  :values)
                """)
            .bind("submission", key)
            .bind("user", schedule.user())
            .bind("owner", AccountTable.ownerOfNew(h, schedule.user(), schedule.owner()))
            .bind("until", schedule.until())
            .bind("paused", schedule.paused())
            .bind("at", schedule.createdAt())
            .bind("due", schedule.due())
            .bind("template", template == null ? null : template.template())
            .bind("values", template == null ? null : template.values());
    bind(update, schedule.order());
    bind(update, RecurrenceColumns.of(schedule.recurrence()));
    return update.executeAndReturnGeneratedKeys("id").mapTo(Long.class).one();
  }

  /** Its tasks are ordered so from now on. */
  static void saveOrder(Handle h, long id, TaskOrder order) {
    Update update =
        h.createUpdate(
                """
                update schedules set name = :name, floor = :floor, load_kg = :load, load_length = :length,
                  load_width = :width, start_x = :startX, start_y = :startY,
                  start_station = :startStation, goal_x = :goalX, goal_y = :goalY,
                  goal_station = :goalStation, priority = :priority, only_robots = :onlyRobots,
                  stops = :stops
                where id = :id
                """)
            .bind("id", id);
    bind(update, order);
    update.execute();
  }

  private static void bind(Update update, TaskOrder order) {
    LoadSize size = order.size();
    update
        .bind("name", order.name())
        .bind("floor", order.floor())
        .bind("load", order.load())
        .bind("length", size == null ? null : size.length())
        .bind("width", size == null ? null : size.width())
        .bind("priority", order.priority())
        .bind("onlyRobots", RobotNames.write(order.onlyRobots()))
        .bind("stops", StopsJson.writeOrder(order.stops()));
    bind(update, "start", order.start());
    bind(update, "goal", order.goal());
  }

  private static void bind(Update update, String end, Where where) {
    Vec2 point = where instanceof Where.Point(Vec2 position) ? position : null;
    update
        .bind(end + "X", point == null ? null : point.x())
        .bind(end + "Y", point == null ? null : point.y())
        .bind(end + "Station", where instanceof Where.Station(String name) ? name : null);
  }

  /** The columns of a recurrence; null: it has no such time. */
  private record RecurrenceColumns(
      String kind,
      @Nullable Instant first,
      @Nullable Duration every,
      @Nullable String weekdays,
      @Nullable LocalTime time,
      @Nullable ZoneId zone) {
    static RecurrenceColumns of(Recurrence recurrence) {
      return switch (recurrence) {
        case Recurrence.Once(Instant at) ->
            new RecurrenceColumns("ONCE", at, null, null, null, null);
        case Recurrence.Every(Instant first, Duration pause) ->
            new RecurrenceColumns("EVERY", first, pause, null, null, null);
        case Recurrence.Weekly(var days, LocalTime time, ZoneId zone) ->
            new RecurrenceColumns("WEEKLY", null, null, names(days), time, zone);
      };
    }

    private static String names(Set<DayOfWeek> days) {
      return days.stream().sorted().map(DayOfWeek::name).collect(Collectors.joining(","));
    }
  }

  private static void bind(Update update, RecurrenceColumns times) {
    update
        .bind("kind", times.kind())
        .bind("first", times.first())
        .bind("every", times.every() == null ? null : times.every().toSeconds())
        .bind("weekdays", times.weekdays())
        .bind("time", Objects.toString(times.time(), null))
        .bind("zone", times.zone() == null ? null : times.zone().getId());
  }

  @Override
  public void advance(
      Schedule schedule,
      @Nullable Instant next,
      @Nullable Long lastTask,
      List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          int changed =
              h.createUpdate(
                      """
                      update schedules set due_at = :next, last_task = :task
                      where id = :id and due_at = :due
                      """)
                  .bind("next", next)
                  .bind("task", lastTask)
                  .bind("id", schedule.id())
                  .bind("due", schedule.due())
                  .execute();
          if (changed > 0) {
            EventTable.addMissing(h, events);
          }
          return null;
        });
  }

  @Override
  public void savePause(long id, boolean paused, @Nullable Instant due, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.createUpdate("update schedules set paused = :paused, due_at = :due where id = :id")
              .bind("paused", paused)
              .bind("due", due)
              .bind("id", id)
              .execute();
          EventTable.addMissing(h, events);
          return null;
        });
  }

  @Override
  public void delete(long id, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.createUpdate("delete from schedules where id = :id").bind("id", id).execute();
          EventTable.addMissing(h, events);
          return null;
        });
  }
}
