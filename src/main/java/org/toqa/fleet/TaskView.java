package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.LoadRecord;
import org.toqa.mission.Mission;
import org.toqa.mission.Question;
import org.toqa.mission.Stop;
import org.toqa.mission.StopProgress;
import org.toqa.mission.StopState;
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
 * @param progress how far it is on its way
 * @param expected when it will be picked up and delivered; null: nothing is said of it yet, or it
 *     is delivered or has ended
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
    LoadRecord load,
    StopProgress progress,
    @Nullable ExpectedTimes expected) {

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
        mission.loadRecord(),
        mission.progress(),
        null);
  }

  public TaskView withLateness(@Nullable Sentence nextLate) {
    return new TaskView(
        task,
        state,
        held,
        robots,
        loadAt,
        waitingFor,
        blocked,
        needs,
        nextLate,
        changedAt,
        load,
        progress,
        expected);
  }

  /**
   * @param reason why it waits
   */
  public TaskView withWaitReason(Sentence reason) {
    return new TaskView(
        task, state, held, robots, loadAt, reason, blocked, needs, late, changedAt, load, progress,
        expected);
  }

  public TaskView withExpected(@Nullable ExpectedTimes times) {
    return new TaskView(
        task,
        state,
        held,
        robots,
        loadAt,
        waitingFor,
        blocked,
        needs,
        late,
        changedAt,
        load,
        progress,
        times);
  }

  public TaskView asBlocked() {
    return new TaskView(
        task,
        state,
        held,
        robots,
        loadAt,
        waitingFor,
        true,
        needs,
        late,
        changedAt,
        load,
        progress,
        expected);
  }

  /**
   * A stop of its way.
   *
   * @param since when its robots came there, where they wait there; else null
   */
  public record StopView(Stop stop, StopState state, @Nullable Instant since) {}

  /** All of its way, the start first and the goal last. */
  public List<StopView> stops() {
    List<Stop> route = task.route();
    return IntStream.range(0, route.size())
        .mapToObj(
            i -> {
              StopState of = stateOfStop(i);
              return new StopView(
                  route.get(i), of, of == StopState.HERE ? progress.waitingSince() : null);
            })
        .toList();
  }

  private StopState stateOfStop(int stop) {
    int next = state == TaskState.CARRYING ? Math.max(1, progress.stop()) : progress.stop();
    if (state.isDelivered() || stop < next) {
      return StopState.PASSED;
    }
    if (stop > next || !state.isAssigned()) {
      return StopState.AHEAD;
    }
    return isWaitingAtStop() ? StopState.HERE : StopState.NEXT;
  }

  /** Whether its robots wait at a stop. */
  public boolean isWaitingAtStop() {
    return progress.waitingSince() != null;
  }

  /** Whether its next stop is to charge. */
  public boolean isChargingNext() {
    int next = state == TaskState.CARRYING ? Math.max(1, progress.stop()) : progress.stop();
    return task.route().get(next).charge() != null;
  }

  /** Where its load still goes, the place first where it is fetched if it is not on board. */
  public List<TaskPlace> placesAhead() {
    List<TaskPlace> stops = task.placesFrom(task.stopAfterFirst(progress));
    return state == TaskState.CARRYING
        ? stops
        : Stream.concat(Stream.of(object()), stops.stream()).toList();
  }

  /** Where the load is fetched; of a drive the stop that its robot has not left. */
  public TaskPlace object() {
    return loadAt != null ? loadAt : task.firstPlace(progress);
  }

  public long id() {
    return task.id();
  }
}
