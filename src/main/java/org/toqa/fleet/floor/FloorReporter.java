package org.toqa.fleet.floor;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.apache.pekko.actor.typed.ActorRef;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.grid.CellRuns;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.Stop;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What a floor tells the manager of itself, its robots and its tasks. */
final class FloorReporter {
  /** A plan that takes so long is likely never to end. */
  private static final Duration PLAN_OVERDUE = Duration.ofSeconds(30);

  /** What the store takes for one change while nothing ails it, and more. */
  private static final Duration STORED_WITHIN = Duration.ofSeconds(2);

  private final FloorState state;
  private final FloorWatch watch;
  private final double usualCharge;
  private final ActorRef<FloorEvent> manager;

  /**
   * @param usualCharge as far as robots charge where nobody said, of 0 to 1
   */
  FloorReporter(
      FloorState state, FloorWatch watch, double usualCharge, ActorRef<FloorEvent> manager) {
    this.usualCharge = usualCharge;
    this.state = state;
    this.watch = watch;
    this.manager = manager;
  }

  void send() {
    state.changed = false;
    manager.tell(
        new FloorEvent.FloorReport(
            floorView(),
            state.robots.values().stream().map(r -> view(r)).toList(),
            state.missions.all().stream().map(this::view).toList(),
            state.missions.takeEnded().stream().map(this::view).toList(),
            alerts()));
  }

  private List<Sentence> alerts() {
    List<Sentence> alerts = new ArrayList<>();
    if (state.storeTrouble() != null) {
      alerts.add(Phrase.DATABASE_AWAY.with());
    }
    if (state.traffic.isPlanningFor(PLAN_OVERDUE, state.now)) {
      alerts.add(Phrase.PLAN_OVERDUE.with(state.floor.name()));
    }
    return alerts;
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
        state.chargerShortage,
        state.missions.all().stream()
            .map(OpenMissions.DatedMission::mission)
            .flatMap(mission -> state.formations.heldLoad(mission).stream())
            .toList());
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
    RobotView view = robot.view(work, path);
    return view.alert() != null ? view : inTheWay(robot, view).map(view::withAlert).orElse(view);
  }

  /** Where it stands in whose way, and what a person can do; empty: it moves by itself. */
  private Optional<Sentence> inTheWay(FloorRobot robot, RobotView view) {
    Pose pose = view.telemetry().pose();
    @Nullable Phrase phrase =
        switch (view.state()) {
          case HOLDING -> Phrase.IN_THE_WAY_ON_HOLD;
          case OUT_OF_SERVICE ->
              robot.isHeard() ? Phrase.IN_THE_WAY_OUT_OF_SERVICE : Phrase.IN_THE_WAY_UNHEARD;
          case CONNECTING, LOST -> Phrase.IN_THE_WAY_UNHEARD;
          case NOT_LOCALISED -> Phrase.IN_THE_WAY_NOT_LOCALISED;
          case ERROR -> Phrase.IN_THE_WAY_WITH_ERROR;
          case IDLE, DRIVING, CHARGING -> null;
        };
    return phrase == null || pose == null
        ? Optional.empty()
        : blockedRobot(robot.name())
            .map(blocked -> phrase.with(blocked, Sentence.of(pose.position())));
  }

  /** The first robot that does not get on since this one stands in its way. */
  private Optional<String> blockedRobot(String name) {
    return state.robots.keySet().stream()
        .filter(state.traffic::hasRobot)
        .filter(other -> !isHeld(other))
        .filter(other -> state.traffic.blockingRobot(other).equals(Optional.of(name)))
        .findFirst();
  }

  /** One that is to stand itself is not kept by others. */
  private boolean isHeld(String name) {
    FloorRobot robot = state.robots.get(name);
    return robot != null && robot.hold.isHeld();
  }

  TaskView view(OpenMissions.DatedMission dated) {
    return dated.view(dated.mission().state().isEnded() ? null : waitReason(dated));
  }

  private @Nullable Sentence waitReason(OpenMissions.DatedMission dated) {
    Sentence ofRobots = waitReason(dated.mission());
    return ofRobots == null && isStoreBehind(dated) ? Phrase.NOT_STORED_YET.with() : ofRobots;
  }

  /** Whether its robots wait until what it became is stored, and have done so for a while. */
  private boolean isStoreBehind(OpenMissions.DatedMission dated) {
    Mission mission = dated.mission();
    return dated.changedAt().plus(STORED_WITHIN).isBefore(state.clock.instant())
        && mission.robots().stream()
            .map(state.missions::storedMissionOf)
            .flatMap(Optional::stream)
            .anyMatch(stored -> stored.id() == mission.id() && stored.state() != mission.state());
  }

  /** Where its robots wait at a stop, whom or what they wait for. */
  private Optional<Sentence> waitAtStop(Mission mission) {
    return mission.waitingStop().map(stop -> waitAtStop(mission, stop));
  }

  private Sentence waitAtStop(Mission mission, Stop stop) {
    Sentence robots = Sentence.names(mission.robots());
    Sentence place = stop.sentence();
    Duration wait = stop.waitTime();
    if (stop.charge() != null) {
      return chargeSentence(robots, stop);
    }
    if (wait == null) {
      return Phrase.WAITS_FOR_PERSON_AT.with(robots, place);
    }
    Phrase phrase =
        stop.awaitsPerson() ? Phrase.WAITS_FOR_PERSON_OR_A_WHILE_AT : Phrase.WAITS_A_WHILE_AT;
    return phrase.with(robots, place, Sentence.of(wait));
  }

  /** What lets it go on, whichever comes first. */
  private Sentence chargeSentence(Sentence robots, Stop stop) {
    List<Sentence> ends = new ArrayList<>();
    stop.chargesUntil(usualCharge)
        .ifPresent(level -> ends.add(Phrase.CHARGED_TO.with(Math.round(100 * level))));
    if (stop.waitTime() != null) {
      ends.add(Phrase.TIME_HAS_PASSED.with(Sentence.of(stop.waitTime())));
    }
    if (stop.awaitsPerson()) {
      ends.add(Phrase.SOMEBODY_SAYS_GO_ON.with());
    }
    return Phrase.CHARGES_UNTIL.with(robots, stop.sentence(), Sentence.joined(Phrase.OR, ends));
  }

  private @Nullable Sentence waitReason(Mission mission) {
    List<Sentence> reasons = new ArrayList<>();
    if (!mission.held() && mission.trouble() == null) {
      waitAtStop(mission).ifPresent(reasons::add);
    }
    for (AssignedRobot c : mission.assignedRobots()) {
      FloorRobot robot = state.robots.get(c.robot());
      if (c.unassigned() || robot == null) {
        continue;
      }
      switch (robot.state()) {
        case CONNECTING, LOST -> reasons.add(Phrase.NOT_CONNECTED.with(robot.name()));
        case NOT_LOCALISED -> reasons.add(Phrase.NOT_LOCALISED.with(robot.name()));
        case ERROR ->
            reasons.add(
                Phrase.ROBOT_AND_CLAUSE.with(
                    robot.name(),
                    Objects.requireNonNullElse(
                        robot.obedience.fault(), Phrase.REPORTS_ERROR.with())));
        case OUT_OF_SERVICE -> reasons.add(Phrase.OUT_OF_SERVICE.with(robot.name()));
        case IDLE, DRIVING, HOLDING, CHARGING -> {
          operationalWaitReason(robot)
              .filter(reason -> !reasons.contains(reason)) // of all of a group
              .ifPresent(reasons::add);
        }
      }
    }
    return switch (reasons.size()) {
      case 0 -> null;
      case 1 -> reasons.getFirst();
      default -> Sentence.joined(Phrase.LISTED_APART, reasons);
    };
  }

  /** That it waits for its turn to charge for its task, or needs help with that. */
  private static Optional<Sentence> waitForCharger(FloorRobot robot) {
    boolean isWaiting = robot.charging.isAwaitingTurn() || robot.charging.alert() != null;
    return robot.charging.isForTask() && isWaiting
        ? Optional.ofNullable(robot.charging.status())
        : Optional.empty();
  }

  private static Optional<Sentence> operationalWaitReason(FloorRobot robot) {
    return Optional.ofNullable(robot.hold.reason())
        .or(() -> Optional.ofNullable(robot.drive.waitReason()))
        .or(() -> waitForCharger(robot))
        .or(
            () ->
                Optional.ofNullable(robot.reportedStopReason())
                    .map(said -> said.replaceFirst("\\.$", "")) // others may follow it
                    .map(Sentence::verbatim));
  }
}
