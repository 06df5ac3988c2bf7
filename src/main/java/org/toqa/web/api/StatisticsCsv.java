package org.toqa.web.api;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.time.OffsetDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.DurationStatistics;
import org.toqa.fleet.history.FailureKind;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.RobotUtilisation;
import org.toqa.fleet.history.WorkStatistics;

/** The figures of a period in lines and columns, with the units in the columns' names. */
final class StatisticsCsv {
  private static final int DECIMALS = 3;

  private StatisticsCsv() {}

  /** A line for each bucket. */
  static CsvWriter series(PeriodStatistics figures) {
    List<String> header = new ArrayList<>(List.of("from", "until"));
    header.addAll(List.of("ordered", "done", "failed", "cancelled"));
    header.addAll(durationColumns("waiting", "delivery", "completion"));
    header.addAll(List.of("distance_m", "battery_used_percent"));
    Stream.of(FailureKind.values()).map(FailureKind::kind).forEach(header::add);
    header.addAll(durationColumns("order_error", "start_error"));
    CsvWriter csv = new CsvWriter(header);
    for (int i = 0; i < figures.period().bucketCount(); i++) {
      List<@Nullable Object> line = new ArrayList<>();
      line.add(boundary(figures.period(), i));
      line.add(boundary(figures.period(), i + 1));
      addFigures(figures.buckets().get(i), line);
      csv.addLine(line.toArray());
    }
    return csv;
  }

  private static void addFigures(WorkStatistics figures, List<@Nullable Object> line) {
    line.addAll(List.of(figures.ordered(), figures.done(), figures.failed(), figures.cancelled()));
    addDurations(figures.waiting(), line);
    addDurations(figures.delivery(), line);
    addDurations(figures.completion(), line);
    line.add(number(figures.metres()));
    line.add(number(100 * figures.battery()));
    Stream.of(FailureKind.values()).map(figures.failures()::get).forEach(line::add);
    addDurations(figures.orderError(), line);
    addDurations(figures.startError(), line);
  }

  private static List<String> durationColumns(String... names) {
    return Stream.of(names)
        .flatMap(name -> Stream.of("tasks", "mean_s", "median_s", "p90_s").map(s -> name + "_" + s))
        .toList();
  }

  private static void addDurations(
      @Nullable DurationStatistics durations, List<@Nullable Object> line) {
    if (durations == null) {
      line.add(0);
      line.add(null);
      line.add(null);
      line.add(null);
    } else {
      line.add(durations.count());
      Stream.of(durations.mean(), durations.median(), durations.p90())
          .map(StatisticsCsv::number)
          .forEach(line::add);
    }
  }

  /** A line for each robot. */
  static CsvWriter robots(PeriodStatistics figures) {
    List<String> header = new ArrayList<>(List.of("robot", "recorded_s"));
    Stream.of(RobotActivity.values())
        .map(activity -> activity.name().toLowerCase(Locale.ROOT) + "_s")
        .forEach(header::add);
    header.addAll(List.of("distance_m", "battery_used_percent"));
    CsvWriter csv = new CsvWriter(header);
    for (RobotUtilisation robot : figures.robots()) {
      List<Object> line = new ArrayList<>();
      line.add(robot.robot());
      line.add(number(robot.recordedSeconds()));
      Stream.of(RobotActivity.values())
          .map(activity -> number(robot.seconds(activity)))
          .forEach(line::add);
      line.add(number(robot.metres()));
      line.add(number(100 * robot.battery()));
      csv.addLine(line.toArray());
    }
    return csv;
  }

  /** ISO 8601, with the offset that the period's zone had then. */
  private static String boundary(Period period, int index) {
    return DateTimeFormatter.ISO_OFFSET_DATE_TIME.format(
        OffsetDateTime.ofInstant(period.borders().get(index), period.zone()));
  }

  private static BigDecimal number(double value) {
    return BigDecimal.valueOf(value).setScale(DECIMALS, RoundingMode.HALF_UP);
  }
}
