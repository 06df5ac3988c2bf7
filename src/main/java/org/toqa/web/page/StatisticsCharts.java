package org.toqa.web.page;

import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.DurationStatistics;
import org.toqa.fleet.history.FailureKind;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.RobotUtilisation;
import org.toqa.fleet.history.WorkStatistics;
import org.toqa.web.page.Chart.Column;
import org.toqa.web.page.Chart.Row;
import org.toqa.web.page.Chart.Shape;
import org.toqa.web.page.Chart.Unit;

/** The figures of a period as charts, in a reader's language. */
final class StatisticsCharts {
  private final PeriodStatistics figures;
  private final List<String> labels;

  StatisticsCharts(PeriodStatistics figures, Locale locale) {
    this.figures = figures;
    this.labels = labels(figures.period(), locale);
  }

  /** Those that run over the period. */
  List<Chart> series() {
    return List.of(
        tasks(),
        durations("delivery", WorkStatistics::delivery),
        durations("waiting", WorkStatistics::waiting),
        durations("completion", WorkStatistics::completion),
        durations("orderError", WorkStatistics::orderError),
        durations("startError", WorkStatistics::startError),
        singleColumn("distance", Unit.METRES, WorkStatistics::metres),
        singleColumn("battery", Unit.SHARE, WorkStatistics::battery),
        failures());
  }

  private Chart tasks() {
    return series(
        "tasks",
        List.of(
            new Column("ordered", Shape.LINE, Unit.COUNT),
            new Column("done", Shape.BAR, Unit.COUNT),
            new Column("failed", Shape.BAR, Unit.COUNT),
            new Column("cancelled", Shape.BAR, Unit.COUNT)),
        f ->
            Stream.of(f.ordered(), f.done(), f.failed(), f.cancelled())
                .map(Long::doubleValue)
                .toList());
  }

  private Chart durations(
      String name, Function<WorkStatistics, @Nullable DurationStatistics> spreadOf) {
    return series(
        name,
        List.of(
            new Column("median", Shape.LINE, Unit.SECONDS),
            new Column("p90", Shape.LINE, Unit.SECONDS),
            new Column("mean", Shape.NONE, Unit.SECONDS),
            new Column("count", Shape.NONE, Unit.COUNT)),
        f -> {
          DurationStatistics spread = spreadOf.apply(f);
          return spread == null
              ? Arrays.asList(null, null, null, 0.0)
              : List.of(spread.median(), spread.p90(), spread.mean(), (double) spread.count());
        });
  }

  private Chart singleColumn(String name, Unit unit, Function<WorkStatistics, Double> value) {
    return series(name, List.of(new Column(name, Shape.BAR, unit)), f -> List.of(value.apply(f)));
  }

  private Chart failures() {
    return series(
        "failures",
        failureKinds().map(failure -> new Column(failure.name(), Shape.BAR, Unit.COUNT)).toList(),
        f ->
            failureKinds()
                .map(failure -> f.failures().getOrDefault(failure, 0L).doubleValue())
                .toList());
  }

  private static Stream<FailureKind> failureKinds() {
    return Stream.of(FailureKind.values()).filter(kind -> !kind.isPlanned());
  }

  private Chart series(
      String name, List<Column> columns, Function<WorkStatistics, List<@Nullable Double>> values) {
    return new Chart(
        name,
        figures.period().step().name(),
        false,
        columns,
        IntStream.range(0, labels.size())
            .mapToObj(i -> new Row(labels.get(i), values.apply(figures.buckets().get(i))))
            .toList());
  }

  /** What each robot did. */
  Chart utilisation() {
    List<Column> columns = new ArrayList<>();
    for (RobotActivity activity : RobotActivity.values()) {
      columns.add(new Column(activity.name(), Shape.BAR, Unit.SHARE));
    }
    columns.add(new Column("recorded", Shape.NONE, Unit.SECONDS));
    columns.add(new Column("distance", Shape.NONE, Unit.METRES));
    columns.add(new Column("battery", Shape.NONE, Unit.SHARE));
    return new Chart(
        "utilisation",
        "robot",
        true,
        columns,
        figures.robots().stream().map(StatisticsCharts::row).toList());
  }

  private static Row row(RobotUtilisation robot) {
    List<@Nullable Double> values = new ArrayList<>();
    for (RobotActivity activity : RobotActivity.values()) {
      values.add(robot.utilisation(activity));
    }
    values.add(robot.recordedSeconds());
    values.add(robot.metres());
    values.add(robot.battery());
    return new Row(robot.robot(), values);
  }

  private static List<String> labels(Period period, Locale locale) {
    DateTimeFormatter format =
        DateTimeFormatter.ofLocalizedPattern(pattern(period)).withLocale(locale);
    return period.borders().stream()
        .limit(period.bucketCount())
        .map(border -> label(border, period, format))
        .toList();
  }

  private static String pattern(Period period) {
    return switch (period.step()) {
      case HOUR -> period.from().equals(period.to()) ? "Hm" : "MMMdHm";
      case DAY, WEEK -> "MMMd";
      case MONTH -> "yMMM";
    };
  }

  /** An hour that comes twice says which one it is. */
  private static String label(Instant border, Period period, DateTimeFormatter format) {
    ZonedDateTime at = border.atZone(period.zone());
    LocalDateTime local = at.toLocalDateTime();
    boolean isAmbiguous = period.zone().getRules().getValidOffsets(local).size() > 1;
    return isAmbiguous ? format.format(at) + " (" + at.getOffset() + ")" : format.format(at);
  }
}
