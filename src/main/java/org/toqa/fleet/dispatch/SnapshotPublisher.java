package org.toqa.fleet.dispatch;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.PathLengths;
import org.toqa.allocation.WaitExplainer;
import org.toqa.allocation.Zone;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView.ZoneView;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.wording.Sentence;

/** Publishes snapshots of the floor. */
final class SnapshotPublisher {
  static final int QUEUED_SHOWN = 100;

  private final DispatchState state;
  private final AllocationRounds rounds;
  private final AllocatorChoice allocator;
  private final LateTaskReporter lateTasks;
  private final TaskForecaster forecaster;
  private final FloorHoldHandler holds;
  private final StoreHealthCheck storeHealth;
  private final LatestSnapshot latest;

  SnapshotPublisher(
      DispatchState state,
      AllocationRounds rounds,
      AllocatorChoice allocator,
      LateTaskReporter lateTasks,
      TaskForecaster forecaster,
      FloorHoldHandler holds,
      StoreHealthCheck storeHealth,
      LatestSnapshot latest) {
    this.state = state;
    this.rounds = rounds;
    this.allocator = allocator;
    this.lateTasks = lateTasks;
    this.forecaster = forecaster;
    this.holds = holds;
    this.storeHealth = storeHealth;
    this.latest = latest;
  }

  void publish() {
    state.changed = false;
    List<RobotView> views = new ArrayList<>();
    Map<Long, TaskView> tasks = new HashMap<>();
    Set<Sentence> alerts = new LinkedHashSet<>();
    if (!storeHealth.isAvailable()) {
      alerts.add(StoreHealthCheck.DATABASE_AWAY);
    }
    state.ended.forEach(t -> tasks.put(t.id(), t));
    firstQueuedTasks().forEach(t -> tasks.put(t.id(), t));
    FloorEvent.FloorReport report = state.report;
    if (report != null) {
      views.addAll(report.robots());
      report.missions().forEach(t -> tasks.put(t.id(), t));
      alerts.addAll(report.alerts());
    }
    state.handedOver.values().forEach(t -> tasks.putIfAbsent(t.id(), t));
    views.sort(Comparator.comparing(RobotView::name));
    List<TaskView> newestFirst =
        tasks.values().stream()
            .map(lateTasks::withLateness)
            .map(forecaster::withExpected)
            .sorted(Comparator.comparingLong(TaskView::id).reversed())
            .toList();
    latest.publish(
        new FleetSnapshot(
            latest.latest().version(),
            state.clock.instant(),
            views,
            newestFirst,
            state.queue.size(),
            report == null ? List.of() : List.of(report.floor().withZones(zones())),
            holds.pause(),
            rounds.negotiations(),
            allocator.word().map(word -> Map.of(state.floor.name(), word)).orElseGet(Map::of),
            List.copyOf(alerts)));
  }

  private List<TaskView> firstQueuedTasks() {
    WaitExplainer plain =
        state.report == null
            ? null
            : new WaitExplainer(state.candidates(), PathLengths.STRAIGHT, state.chargerPositions());
    return state.queue.first(QUEUED_SHOWN).map(q -> view(q, plain)).toList();
  }

  private TaskView view(TaskQueue.Queued queued, @Nullable WaitExplainer plain) {
    if (rounds.isBlocked(queued, plain)) {
      return DispatchState.view(queued, rounds.waitReason(queued, plain)).asBlocked();
    }
    Sentence held = holds.reasonToWait();
    return DispatchState.view(queued, held != null ? held : rounds.waitReason(queued, plain));
  }

  private List<ZoneView> zones() {
    OccupancyGrid grid = state.floor.grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return Zone.of(grid.origin(), grid.origin().plus(size), state.candidates()).stream()
        .map(zone -> new ZoneView(zone.robot(), zone.low(), zone.high()))
        .toList();
  }
}
