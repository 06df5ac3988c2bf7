package org.toqa.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorRobot.Errand;
import org.toqa.grid.CellRuns;
import org.toqa.mission.Carrier;
import org.toqa.mission.Mission;
import org.toqa.traffic.floor.Route;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What a floor tells the manager of itself, its robots and its tasks. */
final class FloorReports {
  private final FloorState state;
  private final FloorWatch watch;
  private final ActorRef<ManagerMessage> manager;

  FloorReports(FloorState state, FloorWatch watch, ActorRef<ManagerMessage> manager) {
    this.state = state;
    this.watch = watch;
    this.manager = manager;
  }

  void send() {
    state.changed = false;
    String trouble = state.storeTrouble();
    List<Sentence> alerts = trouble == null ? List.of() : List.of(StoreWatch.AWAY);
    manager.tell(
        new ManagerMessage.FloorReport(
            floorView(),
            state.robots.values().stream().map(r -> view(r)).toList(),
            state.missions.all().stream().map(this::view).toList(),
            state.missions.takeEnded().stream().map(this::view).toList(),
            alerts));
  }

  private FloorView floorView() {
    Map<String, CellRuns> kept = new TreeMap<>();
    state.robots.values().stream()
        .filter(state::isKept)
        .forEach(r -> kept.put(r.name(), CellRuns.of(state.traffic.held(r.name()))));
    return watch.view(state.hold, kept, state.chargers.faulty());
  }

  RobotView view(FloorRobot robot) {
    Route route =
        state.traffic.knows(robot.name()) ? state.traffic.route(robot.name()) : Route.NONE;
    Errand work =
        state
            .missions
            .of(robot.name())
            .map(m -> state.formations.errand(m, robot.name()))
            .orElse(robot.errand);
    return robot.view(state.floor.name(), work, route);
  }

  TaskView view(OpenMissions.Dated dated) {
    Mission mission = dated.mission();
    return TaskView.of(
        mission, mission.state().isEnded() ? null : waitingFor(mission), dated.changedAt());
  }

  private @Nullable Sentence waitingFor(Mission mission) {
    List<Sentence> reasons = new ArrayList<>();
    for (Carrier c : mission.carriers()) {
      FloorRobot robot = state.robots.get(c.robot());
      if (c.released() || robot == null) {
        continue;
      }
      switch (robot.state()) {
        case CONNECTING, LOST -> reasons.add(Phrase.NOT_CONNECTED.with(robot.name()));
        case NOT_LOCALISED -> reasons.add(Phrase.NOT_LOCALISED.with(robot.name()));
        case ERROR ->
            reasons.add(Phrase.ROBOT_AND_CLAUSE.with(robot.name(), Phrase.REPORTS_ERROR.with()));
        case OUT_OF_SERVICE -> reasons.add(Phrase.OUT_OF_SERVICE.with(robot.name()));
        case IDLE, DRIVING, HOLDING, CHARGING -> {
          if (robot.holdReason != null) {
            reasons.add(robot.holdReason);
          } else if (robot.trouble != null) {
            reasons.add(robot.trouble);
          } else {
            Optional.ofNullable(robot.reasonOfGroup())
                .map(Sentence::verbatim)
                .ifPresent(reasons::add);
          }
        }
      }
    }
    return reasons.isEmpty() ? null : Sentence.joined(Phrase.LISTED_APART, reasons);
  }
}
