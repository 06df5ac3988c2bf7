package org.toqa.fleet.floor;

import static java.util.stream.Collectors.toSet;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.MissionChange;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.TaskView;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionCommand;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Objection;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Lets a floor's missions go on: an event makes a step, the step is stored, and only then its
 * commands become goals of drives.
 */
final class FloorMissions {
  private final FloorState state;
  private final FloorReporter reports;
  private final RobotWatch robotWatch;
  private final double pace;
  private final ActorRef<FloorMessage> self;
  private final ActorRef<FloorEvent> manager;

  /**
   * @param pace as in {@link org.toqa.fleet.FleetRules}
   */
  FloorMissions(
      FloorState state,
      FloorReporter reports,
      RobotWatch robotWatch,
      double pace,
      ActorRef<FloorMessage> self,
      ActorRef<FloorEvent> manager) {
    this.state = state;
    this.reports = reports;
    this.robotWatch = robotWatch;
    this.pace = pace;
    this.self = self;
    this.manager = manager;
  }

  void beginTask(FloorMessage.BeginTask m) {
    if (m.robots().stream().anyMatch(r -> isBusy(r) || !isFree(r))) {
      manager.tell(new FloorEvent.TaskNotBegun(m.mission()));
      return;
    }
    m.robots().forEach(this::retask);
    Mission.Step step = m.mission().assign(m.robots(), m.why());
    Instant at = state.clock.instant();
    saveSteps(
        step,
        at,
        step.history().stream()
            .map(
                text ->
                    new EventRecord(
                        at,
                        EventKind.TASK_ASSIGNED,
                        m.mission().id(),
                        null,
                        EventRecord.SYSTEM,
                        text))
            .toList(),
        refusal -> {});
    reports.send(); // first, so that the task is in every snapshot
    manager.tell(new FloorEvent.TaskBegun(m.mission().id()));
  }

  /** Tasks go to other robots, if all of that is still possible. */
  void exchangeTasks(FloorMessage.ExchangeTasks m) {
    Set<String> givers = m.moves().stream().map(FloorMessage.Move::from).collect(toSet());
    if (!m.moves().stream().allMatch(move -> canMove(move, givers))) {
      return;
    }
    for (FloorMessage.Move move : m.moves()) {
      if (!givers.contains(move.to())) {
        retask(move.to());
      }
    }
    Instant at = state.clock.instant();
    List<Mission.Step> steps = new ArrayList<>();
    List<MissionChange> changes = new ArrayList<>();
    for (FloorMessage.Move move : m.moves()) {
      MissionEvent event = new MissionEvent.Exchanged(move.from(), move.to(), move.why());
      Mission.Step step = state.missions.get(move.task()).orElseThrow().apply(event);
      steps.add(step);
      changes.add(new MissionChange(step.mission(), at, EventRecord.of(step, event, at)));
    }
    saveSteps(steps, changes, refusal -> {});
    reports.send();
  }

  private boolean canMove(FloorMessage.Move move, Set<String> givers) {
    return isFree(move.to())
        && (givers.contains(move.to()) || !isBusy(move.to()))
        && state
            .missions
            .get(move.task())
            .filter(Mission::isExchangeable)
            .filter(mission -> mission.robots().equals(List.of(move.from())))
            .isPresent();
  }

  private void retask(String robot) {
    state
        .missions
        .missionOf(robot)
        .ifPresent(old -> applyEvent(old, new MissionEvent.Retasked(robot)));
  }

  /** A mission that had begun when the server stopped continues in the phase it was stored in. */
  void recover(OpenTask open) {
    Mission mission = open.mission();
    state.missions.put(mission, open.changedAt());
    state.missions.setStored(mission);
    for (AssignedRobot c : mission.assignedRobots()) {
      FloorRobot robot = state.robots.get(c.robot());
      boolean isAtStop = !c.unassigned() && mission.waitingStop().isPresent();
      boolean charges = mission.chargingStop().isPresent(); // its turn says where
      if ((c.isDriving() || isAtStop) && robot != null && !mission.isStopping() && !charges) {
        robot.drive.setGoal(state.formations.driveGoal(mission, c.robot()));
      }
    }
  }

  /** Whether it works for a mission that it cannot be taken from: it is not driving home. */
  private boolean isBusy(String robot) {
    return state
        .missions
        .missionOf(robot)
        .flatMap(mission -> mission.assignedRobot(robot))
        .filter(assigned -> assigned.phase().isCarryingTask())
        .isPresent();
  }

  private boolean isFree(String robot) {
    FloorRobot known = state.robots.get(robot);
    return known != null
        && known.settings.isInService()
        && !known.charging.hasTurn()
        && !known.manual.isActive();
  }

  /**
   * The last of a group comes to its load only when the others stand there too; until then it is
   * asked again, since it stands at its goal.
   *
   * @param stop where it has come; see {@link Mission#stopNumber(Phase)}
   */
  void phaseEnded(long task, String robot, Phase phase, int stop) {
    boolean isToWait =
        phase == Phase.TO_OBJECT
            && state
                .missions
                .get(task)
                .filter(mission -> !state.formations.areOthersInPlace(mission, robot))
                .isPresent();
    if (isToWait) {
      return;
    }
    applyEvent(task, new MissionEvent.PhaseEnded(robot, phase, stop, state.clock.instant()));
  }

  void applyEvent(long task, MissionEvent event) {
    state.missions.get(task).ifPresent(mission -> applyEvent(mission, event));
  }

  private Mission applyEvent(Mission mission, MissionEvent event) {
    return applyEvent(mission, event, refusal -> {});
  }

  private Mission applyEvent(
      Mission mission, MissionEvent event, Consumer<StoreException> refused) {
    Mission.Step applied = mission.apply(event);
    Instant at = state.clock.instant();
    List<Mission.Step> steps = new ArrayList<>();
    List<MissionChange> changes = new ArrayList<>();
    List<Mission> fetchedOf =
        hasFetched(mission, applied.mission()) ? state.leftLoads.fetchedBy(mission) : List.of();
    Mission.Step step = traceLoad(applied, mission, fetchedOf, at);
    if (step.hasChanges()) {
      steps.add(step);
      changes.add(change(step, event, at));
    }
    if (!fetchedOf.isEmpty()) {
      MissionEvent fetched = new MissionEvent.LoadFetched(mission.id());
      for (Mission left : fetchedOf) {
        Mission.Step end = left.apply(fetched);
        steps.add(end);
        changes.add(change(end, fetched, at));
      }
    }
    if (!steps.isEmpty()) {
      saveSteps(steps, changes, refused);
    }
    return step.mission();
  }

  /** A load that another task left there is the same one on. */
  private static Mission.Step traceLoad(
      Mission.Step step, Mission before, List<Mission> fetchedOf, Instant at) {
    Mission owner = fetchedOf.isEmpty() ? before : fetchedOf.getFirst();
    Mission traced = step.mission().withLoadTraced(before, owner.loadRecord().id(), at);
    return new Mission.Step(traced, step.commands(), step.history());
  }

  /** A mission that has ended already stays ended at the time when it did. */
  private MissionChange change(Mission.Step step, MissionEvent event, Instant at) {
    return new MissionChange(
        step.mission(),
        state.leftLoads.endOf(step.mission().id()).orElse(at),
        EventRecord.of(step, event, at));
  }

  private static boolean hasFetched(Mission before, Mission after) {
    return before.state() != TaskState.CARRYING && after.state() == TaskState.CARRYING;
  }

  /** Which loads do not count for which robots, as these stand now. */
  void updatePassableLoads() {
    if (state.leftLoads.isEmpty()) {
      return;
    }
    state.leftLoads.keepRobots(state.robots.keySet());
    for (String robot : state.robots.keySet()) {
      if (state.traffic.hasRobot(robot)) {
        state.leftLoads.updatePassable(robot, fetchedFor(robot), state.traffic);
      }
    }
  }

  private @Nullable Mission fetchedFor(String robot) {
    return state
        .missions
        .missionOf(robot)
        .filter(mission -> mission.state() != TaskState.RETURNING)
        .orElse(null);
  }

  /** Stores the step; its commands are carried out when it is safe. */
  private void saveSteps(
      Mission.Step step, Instant at, List<EventRecord> events, Consumer<StoreException> refused) {
    if (step.hasChanges()) {
      saveSteps(List.of(step), List.of(new MissionChange(step.mission(), at, events)), refused);
    }
  }

  /** Stores steps that belong together, so that a crash finds all of them or none. */
  private void saveSteps(
      List<Mission.Step> steps, List<MissionChange> changes, Consumer<StoreException> refused) {
    changes.forEach(change -> state.missions.put(change.mission(), change.at()));
    changes.forEach(change -> state.leftLoads.update(change.mission(), change.at()));
    state.changed = true;
    state.writer.write(
        () -> state.store.saveMissions(changes),
        () -> steps.forEach(step -> self.tell(new FloorMessage.StepStored(step))),
        refused);
  }

  void stepStored(Mission.Step step) {
    state.missions.setStored(step.mission());
    step.commands().forEach(command -> carryOut(step, command));
    Mission mission = step.mission();
    if (mission.state() == TaskState.QUEUED
        && state.missions.get(mission.id()).equals(Optional.of(mission))) {
      state.missions.remove(mission.id());
      manager.tell(new FloorEvent.TaskReturned(mission));
      reports.send();
    }
  }

  /** What this floor does not have goes back: perhaps it is in the queue by now. */
  void commandTask(FloorMessage.CommandTask m) {
    Optional<Mission> known =
        state.missions.get(m.task()).or(() -> state.leftLoads.missionOf(m.task()));
    if (known.isEmpty()) {
      reports.send();
      manager.tell(new FloorEvent.TaskUnknown(m.task(), m.command(), m.replyTo()));
      return;
    }
    if (known.get().isOutdated(m.command())) {
      m.replyTo().tell(StatusReply.success(new Answer.Outdated<>()));
      return;
    }
    Optional<Objection> objection = known.get().objectionTo(m.command());
    if (objection.isPresent()) {
      m.replyTo().tell(StatusReply.success(Answer.conflict(objection.get())));
      return;
    }
    if (m.command() instanceof MissionEvent.MoveLoad move) {
      Optional<Sentence> against =
          PlaceCheck.objection(state.floor.grid(), Phrase.LOAD_PLACE, move.place());
      if (against.isPresent()) {
        m.replyTo().tell(StatusReply.success(new Answer.Rejected<>("place", against.get())));
        return;
      }
    }
    AtomicReference<@Nullable StoreException> refused = new AtomicReference<>();
    MissionEvent command = m.command().given(state.formations.loadState(known.get()));
    Mission next = applyEvent(known.get(), command, refused::set);
    reports.send();
    TaskView view = reports.view(new OpenMissions.DatedMission(next, state.clock.instant()));
    state.writer.write(() -> {}, () -> m.replyTo().tell(reply(view, refused.get())));
  }

  private static StatusReply<Answer<TaskView>> reply(
      TaskView view, @Nullable StoreException refusal) {
    return refusal == null
        ? StatusReply.success(new Answer.Accepted<>(view))
        : StatusReply.error(refusal);
  }

  private void carryOut(Mission.Step step, MissionCommand command) {
    FloorRobot robot = state.robots.get(command.robot());
    if (robot == null) {
      return;
    }
    long task = step.mission().id();
    switch (command) {
      case MissionCommand.Drive drive -> {
        if (step.mission().chargingStop().isPresent()) {
          robot.drive.dropGoal(task); // it drives when it is its turn
        } else {
          robot.drive.setGoalNow(state.formations.driveGoal(step.mission(), drive.robot()));
        }
      }
      case MissionCommand.Stop stop -> robot.drive.dropGoal(task);
      case MissionCommand.Unassign letGo -> robot.drive.dropGoal(task);
    }
    state.changed = true;
  }

  /** Tells the robot's mission what it must know of the robot. */
  void checkRobot(FloorRobot robot) {
    Optional<Mission> mission = state.missions.missionOf(robot.name());
    if (mission.isEmpty()) {
      return;
    }
    robot.stopWait.update(mission.get(), state.clock.instant(), state.now, pace);
    if (mission.get().isWaitOver(robot.stopWait.waited(state.now))) {
      applyEvent(mission.get(), new MissionEvent.WaitEnded(mission.get().progress().stop()));
      return;
    }
    robotWatch
        .missionEvent(robot, state.formations.loadPlace(mission.get(), robot), state.now)
        .ifPresent(event -> applyEvent(mission.get(), event));
    if (mission.get().isStopping() && robot.drive.goal() == null && robot.hasStopped()) {
      TaskPlace place = state.formations.loadPlace(mission.get(), robot);
      if (place != null) {
        applyEvent(mission.get().id(), new MissionEvent.Stopped(robot.name(), place));
      }
    }
  }
}
