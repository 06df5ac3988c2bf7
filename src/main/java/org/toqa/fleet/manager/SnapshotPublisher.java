package org.toqa.fleet.manager;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.PathLengths;
import org.toqa.allocation.WaitExplainer;
import org.toqa.allocation.Zone;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.ZoneView;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.wording.Sentence;

/** Publishes snapshots of the whole fleet. */
final class SnapshotPublisher {
  private static final int QUEUED_SHOWN = 100;

  private final FleetState fleet;
  private final AllocationRounds rounds;
  private final FloorAllocators allocators;
  private final LateTaskReporter lateTasks;
  private final HoldCommandHandler holds;
  private final StoreHealthCheck storeHealth;
  private final LatestSnapshot latest;

  SnapshotPublisher(
      FleetState fleet,
      AllocationRounds rounds,
      FloorAllocators allocators,
      LateTaskReporter lateTasks,
      HoldCommandHandler holds,
      StoreHealthCheck storeHealth,
      LatestSnapshot latest) {
    this.fleet = fleet;
    this.rounds = rounds;
    this.allocators = allocators;
    this.lateTasks = lateTasks;
    this.holds = holds;
    this.storeHealth = storeHealth;
    this.latest = latest;
  }

  void publish() {
    fleet.changed = false;
    List<RobotView> views = new ArrayList<>();
    Map<Long, TaskView> tasks = new HashMap<>();
    Set<Sentence> alerts = new LinkedHashSet<>();
    if (!storeHealth.isAvailable()) {
      alerts.add(StoreHealthCheck.DATABASE_AWAY);
    }
    alerts.addAll(fleet.missingFloors.values());
    fleet.ended.forEach(t -> tasks.put(t.id(), t));
    firstQueuedTasks().forEach(t -> tasks.put(t.id(), t));
    for (FloorEvent.FloorReport report : fleet.reports.values()) {
      views.addAll(report.robots());
      report.missions().forEach(t -> tasks.put(t.id(), t));
      alerts.addAll(report.alerts());
    }
    fleet.handedOver.values().forEach(t -> tasks.putIfAbsent(t.id(), t));
    views.sort(Comparator.comparing(RobotView::name));
    List<TaskView> newestFirst =
        tasks.values().stream()
            .map(lateTasks::withLateness)
            .sorted(Comparator.comparingLong(TaskView::id).reversed())
            .toList();
    latest.publish(
        new FleetSnapshot(
            latest.latest().version(),
            fleet.clock.instant(),
            views,
            newestFirst,
            fleet.queue.size(),
            floorViews(),
            holds.pause(),
            rounds.negotiations(),
            allocators.words(),
            List.copyOf(alerts)));
  }

  private List<TaskView> firstQueuedTasks() {
    Map<String, WaitExplainer> byFloor = new HashMap<>();
    fleet
        .reports
        .keySet()
        .forEach(
            f ->
                byFloor.put(
                    f,
                    new WaitExplainer(
                        fleet.candidates(f),
                        PathLengths.STRAIGHT,
                        FleetState.chargerPositions(requireNonNull(fleet.floorMaps.get(f))))));
    return fleet
        .queue
        .first(QUEUED_SHOWN)
        .map(q -> view(q, byFloor.get(q.task().floor())))
        .toList();
  }

  private TaskView view(TaskQueue.Queued queued, @Nullable WaitExplainer plain) {
    Sentence noFloor = fleet.missingFloors.get(queued.task().floor());
    if (noFloor != null) {
      return FleetState.view(queued, noFloor).asBlocked();
    }
    if (rounds.isBlocked(queued, plain)) {
      return FleetState.view(queued, rounds.waitReason(queued, plain)).asBlocked();
    }
    Sentence held = holds.reasonToWait(queued.task().floor());
    return FleetState.view(queued, held != null ? held : rounds.waitReason(queued, plain));
  }

  private List<FloorView> floorViews() {
    return fleet.floors.keySet().stream()
        .flatMap(floor -> Stream.ofNullable(fleet.reports.get(floor)))
        .map(report -> report.floor().withZones(zones(report.floor().name())))
        .toList();
  }

  private List<ZoneView> zones(String floor) {
    OccupancyGrid grid = requireNonNull(fleet.floorMaps.get(floor)).grid();
    Vec2 size = new Vec2(grid.width(), grid.height()).times(grid.resolution());
    return Zone.of(grid.origin(), grid.origin().plus(size), fleet.candidates(floor)).stream()
        .map(zone -> new ZoneView(zone.robot(), zone.low(), zone.high()))
        .toList();
  }
}
