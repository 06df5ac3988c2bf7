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
import org.toqa.fleet.RobotUse;
import org.toqa.store.Failure;
import org.toqa.store.Figures;
import org.toqa.store.Period;
import org.toqa.store.PeriodFigures;
import org.toqa.store.RobotFigures;
import org.toqa.store.Spread;
import org.toqa.web.page.Chart.Column;
import org.toqa.web.page.Chart.Row;
import org.toqa.web.page.Chart.Shape;
import org.toqa.web.page.Chart.Unit;

/** The figures of a period as charts, in a reader's language. */
final class StatisticsCharts {
  private final PeriodFigures figures;
  private final List<String> labels;

  StatisticsCharts(PeriodFigures figures, Locale locale) {
    this.figures = figures;
    this.labels = labels(figures.period(), locale);
  }

  /** Those that run over the period. */
  List<Chart> series() {
    return List.of(
        tasks(),
        durations("delivery", Figures::delivery),
        durations("waiting", Figures::waiting),
        durations("completion", Figures::completion),
        ofOne("distance", Unit.METRES, Figures::metres),
        ofOne("battery", Unit.SHARE, Figures::battery),
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

  private Chart durations(String name, Function<Figures, @Nullable Spread> spreadOf) {
    return series(
        name,
        List.of(
            new Column("median", Shape.LINE, Unit.SECONDS),
            new Column("p90", Shape.LINE, Unit.SECONDS),
            new Column("mean", Shape.NONE, Unit.SECONDS),
            new Column("count", Shape.NONE, Unit.COUNT)),
        f -> {
          Spread spread = spreadOf.apply(f);
          return spread == null
              ? Arrays.asList(null, null, null, 0.0)
              : List.of(spread.median(), spread.p90(), spread.mean(), (double) spread.count());
        });
  }

  private Chart ofOne(String name, Unit unit, Function<Figures, Double> value) {
    return series(name, List.of(new Column(name, Shape.BAR, unit)), f -> List.of(value.apply(f)));
  }

  private Chart failures() {
    return series(
        "failures",
        Stream.of(Failure.values())
            .map(failure -> new Column(failure.name(), Shape.BAR, Unit.COUNT))
            .toList(),
        f ->
            Stream.of(Failure.values())
                .map(failure -> f.failures().getOrDefault(failure, 0L).doubleValue())
                .toList());
  }

  private Chart series(
      String name, List<Column> columns, Function<Figures, List<@Nullable Double>> values) {
    return new Chart(
        name,
        figures.period().step().name(),
        false,
        columns,
        IntStream.range(0, labels.size())
            .mapToObj(i -> new Row(labels.get(i), values.apply(figures.series().get(i))))
            .toList());
  }

  /** What each robot did. */
  Chart use() {
    List<Column> columns = new ArrayList<>();
    for (RobotUse use : RobotUse.values()) {
      columns.add(new Column(use.name(), Shape.BAR, Unit.SHARE));
    }
    columns.add(new Column("recorded", Shape.NONE, Unit.SECONDS));
    columns.add(new Column("distance", Shape.NONE, Unit.METRES));
    columns.add(new Column("battery", Shape.NONE, Unit.SHARE));
    return new Chart(
        "use",
        "robot",
        true,
        columns,
        figures.robots().stream().map(StatisticsCharts::row).toList());
  }

  private static Row row(RobotFigures robot) {
    List<@Nullable Double> values = new ArrayList<>();
    for (RobotUse use : RobotUse.values()) {
      values.add(robot.share(use));
    }
    values.add(robot.recorded());
    values.add(robot.metres());
    values.add(robot.battery());
    return new Row(robot.robot(), values);
  }

  private static List<String> labels(Period period, Locale locale) {
    DateTimeFormatter format =
        DateTimeFormatter.ofLocalizedPattern(pattern(period)).withLocale(locale);
    return period.borders().stream()
        .limit(period.buckets())
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
    boolean isTwice = period.zone().getRules().getValidOffsets(local).size() > 1;
    return isTwice ? format.format(at) + " (" + at.getOffset() + ")" : format.format(at);
  }
}
