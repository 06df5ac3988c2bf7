package org.toqa.store;

import java.time.Duration;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.LongStream;
import org.toqa.fleet.RobotUse;
import org.toqa.mission.TaskState;

/** Figures that are being added up. */
final class Tally {
  long ordered;
  final LongStream.Builder waiting = LongStream.builder();
  final LongStream.Builder delivery = LongStream.builder();
  final LongStream.Builder completion = LongStream.builder();
  private final Map<TaskState, Long> states = new EnumMap<>(TaskState.class);
  private final Map<Failure, Long> failures = new EnumMap<>(Failure.class);
  private final Map<String, RobotFigures> robots = new TreeMap<>();

  Tally() {
    for (Failure failure : Failure.values()) {
      failures.put(failure, 0L);
    }
  }

  void addState(TaskState state, long tasks) {
    states.merge(state, tasks, Long::sum);
  }

  void addFailure(Failure failure) {
    failures.merge(failure, 1L, Long::sum);
  }

  void addUse(RobotFigures use) {
    robots.merge(use.robot(), use, Tally::sum);
  }

  private static RobotFigures sum(RobotFigures a, RobotFigures b) {
    Map<RobotUse, Duration> time = new EnumMap<>(a.time());
    b.time().forEach((use, duration) -> time.merge(use, duration, Duration::plus));
    return new RobotFigures(a.robot(), time, a.metres() + b.metres(), a.battery() + b.battery());
  }

  List<RobotFigures> robots() {
    return List.copyOf(robots.values());
  }

  /** Once. */
  Figures figures() {
    return new Figures(
        ordered,
        states.getOrDefault(TaskState.DONE, 0L),
        states.getOrDefault(TaskState.FAILED, 0L),
        states.getOrDefault(TaskState.CANCELLED, 0L),
        Spread.of(waiting.build().toArray()),
        Spread.of(delivery.build().toArray()),
        Spread.of(completion.build().toArray()),
        robots.values().stream().mapToDouble(RobotFigures::metres).sum(),
        robots.values().stream().mapToDouble(RobotFigures::battery).sum(),
        failures);
  }
}
