package org.toqa.web.page;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskView;
import org.toqa.mission.TaskState;

/**
 * Counts over some tasks.
 *
 * @param looked how many tasks were looked at
 * @param byState how many are in each state; a state that no task is in counts 0
 * @param doneToday how many were done since {@code midnight}
 * @param meanSeconds from a task's order to its end, over the tasks that are done; null when none
 *     is
 */
public record TaskStatistics(
    int looked, Map<TaskState, Integer> byState, long doneToday, @Nullable Double meanSeconds) {

  static TaskStatistics of(List<TaskView> tasks, Instant midnight) {
    Map<TaskState, Integer> byState = new EnumMap<>(TaskState.class);
    for (TaskState state : TaskState.values()) {
      byState.put(state, 0);
    }
    tasks.forEach(task -> byState.merge(task.state(), 1, Integer::sum));
    List<TaskView> done = tasks.stream().filter(t -> t.state() == TaskState.DONE).toList();
    Double mean =
        done.isEmpty()
            ? null
            : done.stream().mapToDouble(TaskStatistics::seconds).average().orElseThrow();
    long today = done.stream().filter(t -> !t.changedAt().isBefore(midnight)).count();
    return new TaskStatistics(tasks.size(), byState, today, mean);
  }

  private static double seconds(TaskView task) {
    return Duration.between(task.task().createdAt(), task.changedAt()).toMillis() / 1000.0;
  }
}
