package org.toqa.web.api;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.DurationStatistics;
import org.toqa.fleet.history.Period;
import org.toqa.fleet.history.PeriodStatistics;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.RobotUtilisation;
import org.toqa.fleet.history.WorkStatistics;

/**
 * A period on the wire.
 *
 * @param zone the time zone of which the days are
 */
record StatisticsJson(
    Instant from,
    Instant until,
    String zone,
    Period.Step step,
    FiguresJson total,
    List<BucketJson> series,
    List<RobotUseJson> robots) {

  record BucketJson(Instant from, Instant until, @JsonUnwrapped FiguresJson figures) {}

  /**
   * @param failures how many, by the kind of their events
   */
  record FiguresJson(
      long ordered,
      long done,
      long failed,
      long cancelled,
      @Nullable DurationStatistics waiting,
      @Nullable DurationStatistics delivery,
      @Nullable DurationStatistics completion,
      @Nullable DurationStatistics orderError,
      @Nullable DurationStatistics startError,
      double metres,
      double battery,
      Map<String, Long> failures) {
    static FiguresJson of(WorkStatistics f) {
      Map<String, Long> failures = new TreeMap<>();
      f.failures().forEach((failure, count) -> failures.put(failure.kind(), count));
      return new FiguresJson(
          f.ordered(),
          f.done(),
          f.failed(),
          f.cancelled(),
          f.waiting(),
          f.delivery(),
          f.completion(),
          f.orderError(),
          f.startError(),
          f.metres(),
          f.battery(),
          failures);
    }
  }

  /**
   * @param seconds how long it did what
   */
  record RobotUseJson(
      String name, Map<RobotActivity, Double> seconds, double metres, double battery) {
    static RobotUseJson of(RobotUtilisation robot) {
      Map<RobotActivity, Double> seconds = new TreeMap<>();
      robot.time().keySet().forEach(use -> seconds.put(use, robot.seconds(use)));
      return new RobotUseJson(robot.robot(), seconds, robot.metres(), robot.battery());
    }
  }

  static StatisticsJson of(PeriodStatistics figures) {
    Period period = figures.period();
    List<Instant> borders = period.borders();
    return new StatisticsJson(
        period.begin(),
        period.end(),
        period.zone().getId(),
        period.step(),
        FiguresJson.of(figures.total()),
        IntStream.range(0, period.bucketCount())
            .mapToObj(
                i ->
                    new BucketJson(
                        borders.get(i),
                        borders.get(i + 1),
                        FiguresJson.of(figures.buckets().get(i))))
            .toList(),
        figures.robots().stream().map(RobotUseJson::of).toList());
  }
}
