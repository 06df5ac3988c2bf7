package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.LoadRecord;
import org.toqa.mission.Mission;
import org.toqa.mission.Question;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * A task as readers see it.
 *
 * @param robots names, in the order they were chosen
 * @param loadAt where the load is if that is neither its start nor its goal, else null
 * @param waitingFor a sentence while it waits, else null
 * @param blocked whether it waits for what will not come by itself: a person must change something
 *     or cancel it
 * @param needs what a person must decide, else null
 * @param late a sentence while its deadline cannot be met, else null
 * @param load which one it has
 */
public record TaskView(
    TransportTask task,
    TaskState state,
    boolean held,
    List<String> robots,
    @Nullable TaskPlace loadAt,
    @Nullable Sentence waitingFor,
    boolean blocked,
    @Nullable Question needs,
    @Nullable Sentence late,
    Instant changedAt,
    LoadRecord load) {

  public TaskView {
    robots = List.copyOf(robots);
  }

  /**
   * @param waitingFor a sentence while it waits, else null
   */
  public static TaskView of(Mission mission, @Nullable Sentence waitingFor, Instant changedAt) {
    return new TaskView(
        mission.task(),
        mission.state(),
        mission.held(),
        mission.robots(),
        mission.loadAt(),
        waitingFor,
        false,
        mission.question().orElse(null),
        null,
        changedAt,
        mission.loadRecord());
  }

  public TaskView withLateness(@Nullable Sentence nextLate) {
    return new TaskView(
        task, state, held, robots, loadAt, waitingFor, blocked, needs, nextLate, changedAt, load);
  }

  /**
   * @param reason why it waits
   */
  public TaskView withWaitReason(Sentence reason) {
    return new TaskView(
        task, state, held, robots, loadAt, reason, blocked, needs, late, changedAt, load);
  }

  public TaskView asBlocked() {
    return new TaskView(
        task, state, held, robots, loadAt, waitingFor, true, needs, late, changedAt, load);
  }

  /** Where the load is fetched. */
  public TaskPlace object() {
    return loadAt != null ? loadAt : task.start();
  }

  public long id() {
    return task.id();
  }
}
