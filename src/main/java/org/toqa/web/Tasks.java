package org.toqa.web;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.toqa.fleet.ExpectedTimes;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskView;
import org.toqa.grid.FloorMap;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/** All tasks as readers see them: live where the fleet still has them, else from the archive. */
public final class Tasks {
  private final Services services;

  public Tasks(Services services) {
    this.services = services;
  }

  public Optional<TaskView> task(long id) {
    return services.fleet().snapshots().latest().tasks().stream()
        .filter(task -> task.id() == id)
        .findFirst()
        .or(() -> services.archive().task(id).map(this::withReason));
  }

  /** That of the task; the first one where the task's is no more. */
  public FloorMap floorOf(TaskView task) {
    List<FloorMap> floors = services.fleet().floors();
    return floors.stream()
        .filter(floor -> floor.name().equals(task.task().floor()))
        .findFirst()
        .orElseGet(floors::getFirst);
  }

  public List<TaskView> page(Filter filter, Sort sort, int offset, int limit) {
    return services.archive().tasks(filter, sort, offset, limit).stream().map(live()).toList();
  }

  /** What the fleet knows now of tasks that are stored. */
  UnaryOperator<TaskView> live() {
    Map<Long, TaskView> live =
        services.fleet().snapshots().latest().tasks().stream()
            .collect(Collectors.toMap(TaskView::id, Function.identity()));
    return task -> {
      TaskView now = live.get(task.id());
      return now == null ? withReason(task) : now;
    };
  }

  /** Snapshots hold the first ones of the queue; what else is queued comes after them, or now. */
  private TaskView withReason(TaskView stored) {
    if (stored.state() != TaskState.QUEUED || stored.waitingFor() != null) {
      return stored;
    }
    return isQueueLong()
        ? stored
            .withWaitReason(Phrase.OTHERS_COME_FIRST.with())
            .withExpected(new ExpectedTimes(null, null, Phrase.EXPECTED_LATER.with()))
        : stored.withWaitReason(Phrase.LOOKING_FOR_ROBOT.with());
  }

  private boolean isQueueLong() {
    FleetSnapshot latest = services.fleet().snapshots().latest();
    return latest.queuedCount()
        > latest.tasks().stream().filter(t -> t.state() == TaskState.QUEUED).count();
  }

  public long count(Filter filter) {
    return services.archive().count(filter);
  }
}
