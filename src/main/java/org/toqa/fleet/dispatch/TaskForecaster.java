package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.ExpectedTimes;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetStore.ExpectedDelivery;
import org.toqa.fleet.TaskView;
import org.toqa.forecast.Delay;
import org.toqa.forecast.Expectation;
import org.toqa.forecast.Unknown;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Says when the floor's tasks will be picked up and delivered. That is computed on a thread of its
 * own, once a second, and for no more than a twentieth of the time; a tick pays for a picture of
 * the floor. Confined to the agent of the dispatch.
 */
final class TaskForecaster {
  private static final Logger log = LoggerFactory.getLogger(TaskForecaster.class);

  /** By the clock. */
  private static final Duration INTERVAL = Duration.ofSeconds(1);

  /** How many times as long as it computed it rests. */
  private static final int REST = 19;

  /** What is told anew only where it has moved by more: a second, or this share of what is left. */
  private static final double MOVED = 0.05;

  /** A task is new for so long. */
  private static final Duration NEW = Duration.ofSeconds(10);

  private final DispatchState state;
  private final FleetRules rules;
  private final ActorRef<DispatchMessage> self;
  private final Map<Long, ExpectedTimes> expected = new HashMap<>();
  private final Set<Long> keptAtOrder = new HashSet<>();
  private final Set<Long> keptAtStart = new HashSet<>();

  /** Those that had no robots the last time. */
  private Set<Long> queuedBefore = Set.of();

  private Delay delay = Delay.NONE;
  private Map<String, ForecastPicture.UnderWay> underWay = Map.of();
  private Instant measuredAt;
  private Instant next = Instant.MIN;
  private long restUntil = Long.MIN_VALUE;
  private boolean isComputing;

  /**
   * What came out.
   *
   * @param at the time of ticks of which the picture was
   * @param clockAt the time of the clock likewise
   * @param nanos that it took
   * @param expectations by task
   * @param underWay by robot, what each drives alone
   */
  record Result(
      Instant at,
      Instant clockAt,
      long nanos,
      Map<Long, Expectation> expectations,
      Map<String, ForecastPicture.UnderWay> underWay) {}

  TaskForecaster(DispatchState state, FleetRules rules, ActorRef<DispatchMessage> self) {
    this.state = state;
    this.rules = rules;
    this.self = self;
    this.measuredAt = state.now;
  }

  /** The task with what is expected of it. */
  TaskView withExpected(TaskView task) {
    return isExpected(task) ? task.withExpected(expected.get(task.id())) : task;
  }

  private static boolean isExpected(TaskView task) {
    return !task.state().isEnded() && task.state() != TaskState.RETURNING;
  }

  /** Looks at all tasks anew when it is time. */
  void update(Instant now) {
    if (isComputing
        || state.report == null
        || now.isBefore(next)
        || state.runtime.nanoTime() < restUntil) {
      return;
    }
    next = now.plus(Duration.ofMillis(Math.round(INTERVAL.toMillis() * Math.max(1, rules.pace()))));
    isComputing = true;
    ForecastPicture picture = picture();
    Delay usual = delay;
    Instant clockAt = state.clock.instant();
    var _ =
        CompletableFuture.supplyAsync(
                () -> compute(picture, usual, now, clockAt),
                state.runtime.threadPerTaskExecutor("forecast"))
            .whenComplete(
                (result, failure) -> {
                  if (failure != null) {
                    log.error("Nobody knows when tasks will be delivered.", failure);
                  }
                  self.tell(new DispatchMessage.TasksForecast(result));
                });
  }

  private ForecastPicture picture() {
    Map<Long, TaskView> begun = new TreeMap<>(state.handedOver);
    state.assignedTasks().forEach(task -> begun.put(task.id(), task));
    List<ForecastPicture.Waiting> queue =
        state
            .queue
            .first(SnapshotPublisher.QUEUED_SHOWN)
            .map(
                queued ->
                    new ForecastPicture.Waiting(
                        TaskView.of(queued.mission(), null, queued.since()),
                        queued.job(),
                        state.legs.taskBefore(queued.task()),
                        state.legs.isStopped(queued.task())))
            .toList();
    return new ForecastPicture(
        state.floor,
        state.robotsHere(),
        begun.values().stream().filter(TaskForecaster::isExpected).toList(),
        queue,
        rules,
        state.clock.instant());
  }

  private Result compute(ForecastPicture picture, Delay usual, Instant now, Instant clockAt) {
    long begin = state.runtime.nanoTime();
    Map<Long, Expectation> expectations = picture.forecast(state.distances, usual.factor());
    return new Result(
        now,
        clockAt,
        state.runtime.nanoTime() - begin,
        expectations,
        picture.underWay(state.distances));
  }

  /**
   * @param result null: it failed
   */
  void forecast(@Nullable Result result) {
    isComputing = false;
    if (result == null) {
      return;
    }
    restUntil = state.runtime.nanoTime() + REST * result.nanos();
    measureDelay(result);
    List<ExpectedDelivery> kept = new ArrayList<>();
    Map<Long, TaskView> tasks = openTasks();
    tasks.forEach(
        (id, task) -> {
          Expectation found = result.expectations().get(id);
          if (found != null) {
            tell(task, times(task, found, result.clockAt()));
            keep(task, found, result.clockAt(), kept);
          }
        });
    queuedBefore =
        tasks.values().stream()
            .filter(task -> task.state() == TaskState.QUEUED)
            .map(TaskView::id)
            .collect(Collectors.toUnmodifiableSet());
    expected.keySet().retainAll(tasks.keySet());
    keptAtOrder.retainAll(tasks.keySet());
    keptAtStart.retainAll(tasks.keySet());
    if (!kept.isEmpty()) {
      state.writer.write(() -> state.store.saveExpectations(kept), () -> {});
    }
  }

  private Map<Long, TaskView> openTasks() {
    Map<Long, TaskView> tasks = new TreeMap<>();
    state
        .queue
        .first(SnapshotPublisher.QUEUED_SHOWN)
        .forEach(
            q ->
                tasks.put(
                    q.mission().id(), DispatchState.view(q, DispatchState.LOOKING_FOR_ROBOT)));
    state.handedOver.values().forEach(task -> tasks.put(task.id(), task));
    state.assignedTasks().stream()
        .filter(TaskForecaster::isExpected)
        .forEach(task -> tasks.put(task.id(), task));
    return tasks;
  }

  private void tell(TaskView task, ExpectedTimes times) {
    ExpectedTimes before = expected.get(task.id());
    if (before == null || hasMoved(before, times)) {
      expected.put(task.id(), times);
      state.changed = true;
    }
  }

  private boolean hasMoved(ExpectedTimes before, ExpectedTimes now) {
    return !Objects.equals(before.unknown(), now.unknown())
        || hasMoved(before.pickUp(), now.pickUp())
        || hasMoved(before.delivery(), now.delivery());
  }

  private boolean hasMoved(@Nullable Instant before, @Nullable Instant now) {
    if (before == null || now == null) {
      return !Objects.equals(before, now);
    }
    long left = Math.max(0, Duration.between(state.clock.instant(), now).toMillis());
    long moved = Math.abs(Duration.between(before, now).toMillis());
    return moved > Math.max(1000, MOVED * left);
  }

  private ExpectedTimes times(TaskView task, Expectation found, Instant from) {
    return new ExpectedTimes(
        task.task().isDrive() ? null : instant(found.pickUp(), from),
        instant(found.delivery(), from),
        found.unknown() == null ? null : sentence(found.unknown()));
  }

  /** By the clock by which people live. */
  private @Nullable Instant instant(OptionalDouble seconds, Instant from) {
    return seconds.isPresent()
        ? from.truncatedTo(ChronoUnit.MILLIS)
            .plusMillis(Math.round(1000 * seconds.getAsDouble() / rules.pace()))
        : null;
  }

  private static Sentence sentence(Unknown why) {
    return switch (why) {
      case ON_HOLD -> Phrase.EXPECTED_AFTER_HOLD.with();
      case NEEDS_DECISION -> Phrase.EXPECTED_AFTER_DECISION.with();
      case AWAITS_PERSON -> Phrase.EXPECTED_AFTER_GO_ON.with();
      case NO_ROBOT -> Phrase.EXPECTED_OF_NO_ROBOT.with();
      case NO_PATH -> Phrase.EXPECTED_WITHOUT_PATH.with();
      case AFTER_UNKNOWN -> Phrase.EXPECTED_AFTER_OTHER.with();
      case FAR_BACK -> Phrase.EXPECTED_LATER.with();
    };
  }

  /** What the statistics compare with when it was delivered. */
  private void keep(TaskView task, Expectation found, Instant from, List<ExpectedDelivery> kept) {
    Instant delivery = instant(found.delivery(), from);
    if (delivery == null) {
      return;
    }
    if (isRecent(task.task().createdAt(), from) && keptAtOrder.add(task.id())) {
      kept.add(new ExpectedDelivery(task.id(), false, delivery));
    }
    if (task.state() != TaskState.QUEUED
        && (queuedBefore.contains(task.id()) || isRecent(task.task().createdAt(), from))
        && keptAtStart.add(task.id())) {
      kept.add(new ExpectedDelivery(task.id(), true, delivery));
    }
  }

  private static boolean isRecent(Instant then, Instant now) {
    return then.plus(NEW).isAfter(now);
  }

  /** By how much robots that drive for the same as the last time came nearer to where they go. */
  private void measureDelay(Result result) {
    double elapsed = Duration.between(measuredAt, result.at()).toMillis() / 1000.0;
    double driving = 0;
    double progress = 0;
    for (Map.Entry<String, ForecastPicture.UnderWay> entry : result.underWay().entrySet()) {
      ForecastPicture.UnderWay before = underWay.get(entry.getKey());
      if (before != null && before.isSameDrive(entry.getValue())) {
        driving += elapsed;
        progress += before.seconds() - entry.getValue().seconds();
      }
    }
    delay = delay.measured(elapsed, driving, progress);
    underWay = result.underWay();
    measuredAt = result.at();
  }
}
