package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.dispatch.DeliveryForecast.Delivery;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Which tasks cannot be delivered by their deadlines. Confined to one agent. */
final class DeadlineWatch {
  private final double pace;
  private final Map<Long, Sentence> lateTasks = new HashMap<>();

  /** Tasks of an earlier run of the server, which was told of them already. */
  private final Set<Long> reportedBefore;

  /**
   * @param pace as in {@link org.toqa.fleet.FleetRules}
   * @param open tasks that are not ended when the server starts
   */
  DeadlineWatch(double pace, Set<Long> open) {
    this.pace = pace;
    this.reportedBefore = new HashSet<>(open);
  }

  /** Whether somebody waits for it at a time that was said. */
  static boolean hasOpenDeadline(TaskView task) {
    return task.task().deadline() != null
        && !task.state().isEnded()
        && task.state() != TaskState.RETURNING;
  }

  /**
   * @param delivery the earliest one
   * @return a sentence if it has just become clear that the task will be late
   */
  Optional<Sentence> check(TaskView task, Delivery delivery, Instant now) {
    Instant deadline = task.task().deadline();
    if (deadline == null) {
      return Optional.empty();
    }
    boolean isNew = !reportedBefore.remove(task.id());
    Duration left = Duration.ofMillis(Math.round(delivery.left().toMillis() / pace));
    Duration after = Duration.between(deadline, now.plus(left));
    if (!after.isPositive()) {
      lateTasks.remove(task.id());
      return Optional.empty();
    }
    Sentence sentence = Phrase.CANNOT_BE_IN_TIME.with(delivery.robot(), Sentence.of(after));
    return lateTasks.putIfAbsent(task.id(), sentence) == null && isNew
        ? Optional.of(sentence)
        : Optional.empty();
  }

  void forget(long task) {
    lateTasks.remove(task);
    reportedBefore.remove(task);
  }

  /** The task with what is known of its deadline. */
  TaskView withLateness(TaskView task) {
    if (!hasOpenDeadline(task)) {
      lateTasks.remove(task.id());
      return task;
    }
    return task.withLateness(lateTasks.get(task.id()));
  }
}
