package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.Query;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.FailureKind;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.RobotUtilisation;
import org.toqa.fleet.history.StatisticsArchive;
import org.toqa.mission.TaskState;

/**
 * Tells what happened in a period. The database counts: a statement has a branch for each bucket,
 * which is a range of an index. Only durations come one by one, for their percentiles.
 */
public final class JdbiStatisticsArchive implements StatisticsArchive {
  private static final double MILLIMETRES = 1000;

  private static final String ORDERED =
      """
      select %1$d as bucket, count(*) as tasks from tasks
      where created_at >= :border%1$d and created_at < :border%2$d FLOOR
      """;

  /** Of all states: where one were asked for, H2 would take the index of states. */
  private static final String CHANGED =
      """
      select %1$d as bucket, state, count(*) as tasks from tasks
      where changed_at >= :border%1$d and changed_at < :border%2$d FLOOR group by state
      """;

  private static final String WAITING =
      """
      select %1$d as bucket, timestampdiff(microsecond, created_at, assigned_at) as took from tasks
      where assigned_at >= :border%1$d and assigned_at < :border%2$d FLOOR
      """;

  private static final String DELIVERY =
      """
      select %1$d as bucket, timestampdiff(microsecond, created_at, delivered_at) as took,
        abs(timestampdiff(microsecond, expected_at_order, delivered_at)) as order_error,
        abs(timestampdiff(microsecond, expected_at_start, delivered_at)) as start_error
      from tasks
      where delivered_at >= :border%1$d and delivered_at < :border%2$d FLOOR
      """;

  private static final String COMPLETION =
      """
      select %1$d as bucket,
        case when state = 'DONE' then timestampdiff(microsecond, created_at, changed_at) end as took
      from tasks where changed_at >= :border%1$d and changed_at < :border%2$d FLOOR
      """;

  private static final String UTILISATION =
      """
      select %1$d as bucket, (select name from robots where id = robot_id) as robot,
        sum(way_mm) as way_mm, sum(battery) as battery, SUMS
      from robot_use where at >= :border%1$d and at < :border%2$d ROBOTS group by robot_id
      """
          .replace("SUMS", JdbiUtilisationStore.columns("sum(%1$s) as %1$s"));

  /** A step of a task may have told several sentences; a standstill is told for each robot. */
  private static final String FAILURES =
      """
      select distinct at, kind, task_id, case when kind <> :standstill then robot end as robot
      from events where kind in (<kinds>) and at >= :begin and at < :end FLOOR
      """;

  private final SqlExecutor sql;

  public JdbiStatisticsArchive(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public PeriodStatistics statistics(Period period, @Nullable String floor) {
    return sql.withHandle(h -> new PeriodQuery(h, period, floor).read());
  }

  private interface RowReader {
    void read(ResultSet row, StatisticsAccumulator tally) throws SQLException;
  }

  /** One reading of one period. */
  private static final class PeriodQuery {
    private final Handle handle;
    private final Period period;
    private final @Nullable String floor;
    private final List<StatisticsAccumulator> buckets;
    private final StatisticsAccumulator total = new StatisticsAccumulator();

    PeriodQuery(Handle handle, Period period, @Nullable String floor) {
      this.handle = handle;
      this.floor = floor;
      this.period = period;
      this.buckets =
          Stream.generate(StatisticsAccumulator::new).limit(period.bucketCount()).toList();
    }

    PeriodStatistics read() {
      each(ORDERED, (row, tally) -> tally.ordered += row.getLong("tasks"));
      each(CHANGED, (row, tally) -> tally.addState(state(row), row.getLong("tasks")));
      each(WAITING, (row, tally) -> addDuration(row, "took", tally.waitingMicros));
      each(
          DELIVERY,
          (row, tally) -> {
            addDuration(row, "took", tally.deliveryMicros);
            addDuration(row, "order_error", tally.orderErrorMicros);
            addDuration(row, "start_error", tally.startErrorMicros);
          });
      each(COMPLETION, (row, tally) -> addDuration(row, "took", tally.completionMicros));
      each(UTILISATION, (row, tally) -> tally.addUtilisation(utilisation(row)));
      readFailures();
      return new PeriodStatistics(
          period,
          total.statistics(),
          buckets.stream().map(StatisticsAccumulator::statistics).toList(),
          total.robots());
    }

    /** Every row counts for its bucket and for the whole. */
    private void each(String branch, RowReader reader) {
      Query query =
          query(
              IntStream.range(0, period.bucketCount())
                  .mapToObj(i -> branch.formatted(i, i + 1))
                  .collect(Collectors.joining(" union all ")));
      for (int i = 0; i < period.borders().size(); i++) {
        query.bind("border" + i, period.borders().get(i));
      }
      query.scanResultSet(
          (rows, context) -> {
            ResultSet row = rows.get();
            while (row.next()) {
              reader.read(row, buckets.get(row.getInt("bucket")));
              reader.read(row, total);
            }
            return total;
          });
    }

    /** Of the floor alone, where one is asked for. */
    private Query query(String statement) {
      if (floor == null) {
        return handle.createQuery(statement.replace("FLOOR", "").replace("ROBOTS", ""));
      }
      return handle
          .createQuery(
              statement
                  .replace("FLOOR", "and floor = :floor")
                  .replace(
                      "ROBOTS", "and robot_id in (select id from robots where floor = :floor)"))
          .bind("floor", floor);
    }

    private void readFailures() {
      query(FAILURES)
          .bind("standstill", FailureKind.STANDSTILL.kind())
          .bindList("kinds", Stream.of(FailureKind.values()).map(FailureKind::kind).toList())
          .bind("begin", period.begin())
          .bind("end", period.end())
          .scanResultSet(
              (rows, context) -> {
                ResultSet row = rows.get();
                while (row.next()) {
                  FailureKind failure = FailureKind.of(row.getString("kind"));
                  buckets
                      .get(period.bucketIndex(DatabaseTypes.instant(row, "at")))
                      .addFailure(failure);
                  total.addFailure(failure);
                }
                return total;
              });
    }
  }

  private static void addDuration(ResultSet row, String column, LongStream.Builder durations)
      throws SQLException {
    long microseconds = row.getLong(column);
    if (!row.wasNull()) {
      durations.add(microseconds);
    }
  }

  private static TaskState state(ResultSet row) throws SQLException {
    return TaskState.valueOf(row.getString("state"));
  }

  private static RobotUtilisation utilisation(ResultSet row) throws SQLException {
    Map<RobotActivity, Duration> time = new EnumMap<>(RobotActivity.class);
    for (RobotActivity use : RobotActivity.values()) {
      time.put(use, Duration.ofMillis(row.getLong(JdbiUtilisationStore.column(use))));
    }
    return new RobotUtilisation(
        row.getString("robot"),
        time,
        row.getLong("way_mm") / MILLIMETRES,
        row.getDouble("battery"));
  }
}
