package org.toqa.store;

import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.LongStream;
import org.toqa.fleet.history.DurationStatistics;
import org.toqa.fleet.history.FailureKind;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.RobotUtilisation;
import org.toqa.fleet.history.WorkStatistics;
import org.toqa.mission.TaskState;

/** Figures that are being added up. */
final class StatisticsAccumulator {
  long ordered;
  final LongStream.Builder waitingMicros = LongStream.builder();
  final LongStream.Builder deliveryMicros = LongStream.builder();
  final LongStream.Builder completionMicros = LongStream.builder();
  final LongStream.Builder orderErrorMicros = LongStream.builder();
  final LongStream.Builder startErrorMicros = LongStream.builder();
  private final Map<TaskState, Long> states = new EnumMap<>(TaskState.class);
  private final Map<FailureKind, Long> failures = new EnumMap<>(FailureKind.class);
  private final Map<String, RobotUtilisation> robots = new TreeMap<>();

  StatisticsAccumulator() {
    for (FailureKind failure : FailureKind.values()) {
      failures.put(failure, 0L);
    }
  }

  void addState(TaskState state, long tasks) {
    states.merge(state, tasks, Long::sum);
  }

  void addFailure(FailureKind failure) {
    failures.merge(failure, 1L, Long::sum);
  }

  void addUtilisation(RobotUtilisation use) {
    robots.merge(use.robot(), use, StatisticsAccumulator::sum);
  }

  private static RobotUtilisation sum(RobotUtilisation a, RobotUtilisation b) {
    Map<RobotActivity, Duration> time = new EnumMap<>(a.time());
    b.time().forEach((use, duration) -> time.merge(use, duration, Duration::plus));
    return new RobotUtilisation(
        a.robot(), time, a.metres() + b.metres(), a.battery() + b.battery());
  }

  List<RobotUtilisation> robots() {
    return List.copyOf(robots.values());
  }

  /** Once. */
  WorkStatistics statistics() {
    return new WorkStatistics(
        ordered,
        states.getOrDefault(TaskState.DONE, 0L),
        states.getOrDefault(TaskState.FAILED, 0L),
        states.getOrDefault(TaskState.CANCELLED, 0L),
        DurationStatistics.of(waitingMicros.build().toArray()),
        DurationStatistics.of(deliveryMicros.build().toArray()),
        DurationStatistics.of(completionMicros.build().toArray()),
        DurationStatistics.of(orderErrorMicros.build().toArray()),
        DurationStatistics.of(startErrorMicros.build().toArray()),
        robots.values().stream().mapToDouble(RobotUtilisation::metres).sum(),
        robots.values().stream().mapToDouble(RobotUtilisation::battery).sum(),
        failures);
  }
}
