package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;

/**
 * A task as readers see it.
 *
 * @param robots names, in the order they were chosen
 * @param waitingFor a sentence while it waits, else null
 * @param needs what a person must decide, else null
 */
public record TaskView(
    TransportTask task,
    TaskState state,
    boolean held,
    List<String> robots,
    @Nullable String waitingFor,
    @Nullable Question needs,
    Instant changedAt) {

  public TaskView {
    robots = List.copyOf(robots);
  }

  public long id() {
    return task.id();
  }

  /** A decision that only a person can take. */
  public record Question(String question, List<String> answers) {}
}
