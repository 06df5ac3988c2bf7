package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.toqa.allocation.AllocationTask;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Mission;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;

/**
 * The tasks that no robot has, in the order in which they are to be served. Coming and going costs
 * little however many there are. Confined to one agent.
 */
final class TaskQueue {
  private final Map<Long, Queued> byId = new HashMap<>();
  private final TreeMap<AllocationTask, Queued> inOrder =
      new TreeMap<>(AllocationTask.BY_PRECEDENCE);

  /**
   * @param since when it came, or came back, into the queue
   * @param stored whether it is in the store as it is here
   */
  record Queued(Mission mission, AllocationTask job, Instant since, boolean stored) {
    TransportTask task() {
      return mission.task();
    }

    boolean canBegin() {
      return stored && !mission.held();
    }
  }

  void add(Mission mission, Instant since, boolean stored) {
    remove(mission.id());
    Queued queued = new Queued(mission, job(mission), since, stored);
    byId.put(mission.id(), queued);
    inOrder.put(queued.job(), queued);
  }

  private static AllocationTask job(Mission mission) {
    return job(mission.task(), mission.object(), mission.progress());
  }

  /**
   * @param object where the load is fetched
   * @param progress how far it has come already
   */
  static AllocationTask job(TransportTask task, TaskPlace object, StopProgress progress) {
    List<Vec2> ahead =
        task.placesFrom(task.stopAfterFirst(progress)).stream().map(TaskPlace::position).toList();
    return new AllocationTask(
            task.id(),
            task.load(),
            object.position(),
            task.goal().position(),
            AllocationTask.waitingSince(task.createdAt(), task.priority(), task.deadline()))
        .withOnlyRobots(task.onlyRobots())
        .withStops(ahead.subList(0, Math.max(0, ahead.size() - 1)), task.hasCharging());
  }

  Optional<Queued> get(long id) {
    return Optional.ofNullable(byId.get(id));
  }

  /** The task, if it was in the queue. */
  Optional<Mission> remove(long id) {
    Optional<Queued> queued = Optional.ofNullable(byId.remove(id));
    queued.ifPresent(q -> inOrder.remove(q.job()));
    return queued.map(Queued::mission);
  }

  int size() {
    return byId.size();
  }

  Stream<Queued> first(int limit) {
    return inOrder.values().stream().limit(limit);
  }

  Stream<TransportTask> tasks() {
    return byId.values().stream().map(Queued::task);
  }

  /** The first ones that may begin and fit. */
  List<AllocationTask> firstJobs(Predicate<Queued> fits, int limit) {
    return inOrder.values().stream()
        .filter(q -> q.canBegin() && fits.test(q))
        .limit(limit)
        .map(Queued::job)
        .toList();
  }
}
