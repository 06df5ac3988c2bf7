package org.toqa.fleet;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.toqa.allocation.Travel;
import org.toqa.allocation.WaitingReason;
import org.toqa.wording.Sentence;

/** Hangs up what is to be seen of the whole fleet. */
final class FleetPicture {
  private static final int QUEUED_SHOWN = 100;

  private final FleetState fleet;
  private final AllocationRounds rounds;
  private final LateTasks late;
  private final Holds holds;
  private final StoreWatch storeWatch;
  private final SnapshotBoard board;

  FleetPicture(
      FleetState fleet,
      AllocationRounds rounds,
      LateTasks late,
      Holds holds,
      StoreWatch storeWatch,
      SnapshotBoard board) {
    this.fleet = fleet;
    this.rounds = rounds;
    this.late = late;
    this.holds = holds;
    this.storeWatch = storeWatch;
    this.board = board;
  }

  void publish() {
    fleet.changed = false;
    List<RobotView> views = new ArrayList<>();
    Map<Long, TaskView> tasks = new HashMap<>();
    Set<Sentence> alerts = new LinkedHashSet<>();
    if (!storeWatch.answers()) {
      alerts.add(StoreWatch.AWAY);
    }
    fleet.ended.forEach(t -> tasks.put(t.id(), t));
    firstOfQueue().forEach(t -> tasks.put(t.id(), t));
    for (ManagerMessage.FloorReport report : fleet.reports.values()) {
      views.addAll(report.robots());
      report.missions().forEach(t -> tasks.put(t.id(), t));
      alerts.addAll(report.alerts());
    }
    fleet.handedOver.values().forEach(t -> tasks.putIfAbsent(t.id(), t));
    views.sort(Comparator.comparing(RobotView::name));
    List<TaskView> newestFirst =
        tasks.values().stream()
            .map(late::told)
            .sorted(Comparator.comparingLong(TaskView::id).reversed())
            .toList();
    board.publish(
        new FleetSnapshot(
            board.latest().version() + 1,
            fleet.clock.instant(),
            views,
            newestFirst,
            fleet.queue.size(),
            floorViews(),
            holds.pause(),
            List.copyOf(alerts)));
  }

  private List<TaskView> firstOfQueue() {
    Map<String, WaitingReason> byFloor = new HashMap<>();
    fleet
        .reports
        .keySet()
        .forEach(
            f ->
                byFloor.put(
                    f,
                    new WaitingReason(
                        fleet.candidates(f),
                        Travel.STRAIGHT,
                        FleetState.chargers(requireNonNull(fleet.maps.get(f))))));
    return fleet
        .queue
        .first(QUEUED_SHOWN)
        .map(q -> FleetState.view(q, rounds.reason(q, byFloor.get(q.task().floor()))))
        .toList();
  }

  private List<FloorView> floorViews() {
    return fleet.floors.keySet().stream()
        .flatMap(floor -> Stream.ofNullable(fleet.reports.get(floor)))
        .map(ManagerMessage.FloorReport::floor)
        .toList();
  }
}
