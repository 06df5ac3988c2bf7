package org.toqa.fleet.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.grid.CellRuns;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What a floor tells the manager of itself, its robots and its tasks. */
final class FloorReporter {
  private final FloorState state;
  private final FloorWatch watch;
  private final ActorRef<FloorEvent> manager;

  FloorReporter(FloorState state, FloorWatch watch, ActorRef<FloorEvent> manager) {
    this.state = state;
    this.watch = watch;
    this.manager = manager;
  }

  void send() {
    state.changed = false;
    String trouble = state.storeTrouble();
    List<Sentence> alerts = trouble == null ? List.of() : List.of(Phrase.DATABASE_AWAY.with());
    manager.tell(
        new FloorEvent.FloorReport(
            floorView(),
            state.robots.values().stream().map(r -> view(r)).toList(),
            state.missions.all().stream().map(this::view).toList(),
            state.missions.takeEnded().stream().map(this::view).toList(),
            alerts));
  }

  private FloorView floorView() {
    Map<String, CellRuns> kept = new TreeMap<>();
    state.robots.values().stream()
        .filter(state::hasReservedCells)
        .forEach(r -> kept.put(r.name(), CellRuns.of(state.traffic.allocatedCells(r.name()))));
    return watch.view(
        state.hold,
        kept,
        state.chargers.faultyChargers(),
        state.leftLoads.views(),
        state.chargerShortage);
  }

  RobotView view(FloorRobot robot) {
    RemainingPath path =
        state.traffic.hasRobot(robot.name())
            ? state.traffic.remainingPath(robot.name())
            : RemainingPath.NONE;
    DriveGoal work =
        state
            .missions
            .missionOf(robot.name())
            .map(m -> state.formations.driveGoal(m, robot.name()))
            .orElse(robot.drive.goal());
    return robot.view(work, path);
  }

  TaskView view(OpenMissions.DatedMission dated) {
    Mission mission = dated.mission();
    return TaskView.of(
        mission, mission.state().isEnded() ? null : waitReason(mission), dated.changedAt());
  }

  private @Nullable Sentence waitReason(Mission mission) {
    List<Sentence> reasons = new ArrayList<>();
    for (AssignedRobot c : mission.assignedRobots()) {
      FloorRobot robot = state.robots.get(c.robot());
      if (c.unassigned() || robot == null) {
        continue;
      }
      switch (robot.state()) {
        case CONNECTING, LOST -> reasons.add(Phrase.NOT_CONNECTED.with(robot.name()));
        case NOT_LOCALISED -> reasons.add(Phrase.NOT_LOCALISED.with(robot.name()));
        case ERROR ->
            reasons.add(Phrase.ROBOT_AND_CLAUSE.with(robot.name(), Phrase.REPORTS_ERROR.with()));
        case OUT_OF_SERVICE -> reasons.add(Phrase.OUT_OF_SERVICE.with(robot.name()));
        case IDLE, DRIVING, HOLDING, CHARGING -> {
          operationalWaitReason(robot).ifPresent(reasons::add);
        }
      }
    }
    return reasons.isEmpty() ? null : Sentence.joined(Phrase.LISTED_APART, reasons);
  }

  private static Optional<Sentence> operationalWaitReason(FloorRobot robot) {
    return Optional.ofNullable(robot.hold.reason())
        .or(() -> Optional.ofNullable(robot.drive.waitReason()))
        .or(() -> Optional.ofNullable(robot.groupStopReason()).map(Sentence::verbatim));
  }
}
