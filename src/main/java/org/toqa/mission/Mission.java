package org.toqa.mission;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A task's life: a pure state machine over the three phases (Tanta, "Task phases").
 *
 * <p>Phase 2 starts when all its robots are at the object; in phase 3 each drives home alone. The
 * task is DONE when the last of its robots has parked, failed or taken another task. A robot that
 * fails before it has the load gives the task back to the queue; with the load on board a person is
 * asked. Nothing here knows a clock, a store or a socket: {@link #apply} answers the next state,
 * what to do once it is stored, and what the history says.
 *
 * @param held whether a person has put it on hold
 * @param ending what becomes of the load on board, once the task was cancelled
 * @param setDownPlace where the load was fetched last, or is, if that is neither its start nor its
 *     goal
 * @param trouble what keeps a robot from going on, if anything
 * @param load null: its own, which is at its start since the task was ordered
 * @param progress how far it is on its way
 */
public record Mission(
    TransportTask task,
    TaskState state,
    List<AssignedRobot> assignedRobots,
    boolean held,
    @Nullable LoadChoice ending,
    @Nullable TaskPlace setDownPlace,
    @Nullable Trouble trouble,
    @Nullable LoadRecord load,
    StopProgress progress) {

  /**
   * @param history sentences for the task's history; empty when the event changed nothing
   */
  public record Step(Mission mission, List<MissionCommand> commands, List<Sentence> history) {
    public Step {
      commands = List.copyOf(commands);
      history = List.copyOf(history);
    }

    public boolean hasChanges() {
      return !history.isEmpty();
    }
  }

  public Mission {
    assignedRobots = List.copyOf(assignedRobots);
  }

  /** Of a task whose load is where it was when that was ordered. */
  public Mission(
      TransportTask task,
      TaskState state,
      List<AssignedRobot> assignedRobots,
      boolean held,
      @Nullable LoadChoice ending,
      @Nullable TaskPlace setDownPlace,
      @Nullable Trouble trouble) {
    this(
        task, state, assignedRobots, held, ending, setDownPlace, trouble, null, StopProgress.START);
  }

  /** A task that has no robots yet. */
  public static Mission queued(TransportTask task) {
    return new Mission(task, TaskState.QUEUED, List.of(), false, null, null, null);
  }

  /** Robots were chosen for a queued task. */
  public Step assign(List<String> robots, Sentence why) {
    Mission mission =
        withAssignedRobots(robots.stream().map(AssignedRobot::of).toList())
            .withState(TaskState.ASSIGNED)
            .withTrouble(null);
    return mission.step(
        mission.driveCommands(Phase.TO_OBJECT), Phrase.GIVEN_TO.with(Sentence.names(robots), why));
  }

  /** The task's id. */
  public long id() {
    return task.id();
  }

  public Optional<AssignedRobot> assignedRobot(String robot) {
    for (AssignedRobot assigned : assignedRobots) {
      if (assigned.robot().equals(robot)) {
        return Optional.of(assigned);
      }
    }
    return Optional.empty();
  }

  /** The names, in the order they were chosen. */
  public List<String> robots() {
    return state == TaskState.QUEUED
        ? List.of()
        : assignedRobots.stream().map(AssignedRobot::robot).toList();
  }

  /** Where the load is fetched; of a drive the stop that its robot has not left. */
  public TaskPlace object() {
    return setDownPlace != null ? setDownPlace : task.firstPlace(progress);
  }

  /** Where the load is if that is neither its start nor its goal; null too while it is carried. */
  public @Nullable TaskPlace loadAt() {
    if (state != TaskState.CARRYING) {
      return setDownPlace;
    }
    return trouble == null ? null : trouble.place();
  }

  public LoadRecord loadRecord() {
    return load == null ? new LoadRecord(task.id(), task.createdAt()) : load;
  }

  /** The same after the load was moved, if it was. */
  public Mission withLoadTraced(Mission before, long loadId, Instant at) {
    return hasLoadWhereIn(before)
        ? this
        : new Mission(
            task,
            state,
            assignedRobots,
            held,
            ending,
            setDownPlace,
            trouble,
            new LoadRecord(loadId, at),
            progress);
  }

  private boolean hasLoadWhereIn(Mission before) {
    return isOnBoard() == before.isOnBoard()
        && state.isDelivered() == before.state.isDelivered()
        && Objects.equals(setDownPlace, before.setDownPlace);
  }

  private boolean isOnBoard() {
    return state == TaskState.CARRYING;
  }

  /** Where its load lies on the floor though it has ended. */
  public Optional<TaskPlace> leftLoad() {
    return state == TaskState.CANCELLED || state == TaskState.FAILED
        ? Optional.ofNullable(setDownPlace)
        : Optional.empty();
  }

  /** Where the load on board is carried. */
  public TaskPlace destination() {
    return ending == LoadChoice.BACK ? task.start() : stopAhead().place();
  }

  /** The number, from 0, of the stop to which the load is carried, or will be first. */
  public int stopNumber() {
    return Math.max(1, progress.stop());
  }

  /**
   * Where the load goes from {@link #object}, stop by stop: the same while it is fetched and
   * carried, also those stops that it has left since.
   */
  public List<TaskPlace> placesFromObject() {
    return task.placesFrom(
        state == TaskState.CARRYING || state == TaskState.RETURNING
            ? progress.fetchedBefore()
            : stopNumber());
  }

  /**
   * The number, from 0, of the stop to which its robots drive in that phase; 0 too where that is
   * none.
   */
  public int stopNumber(Phase phase) {
    return switch (phase) {
      case TO_OBJECT -> task.isDrive() ? progress.stop() : 0;
      case TO_GOAL -> stopNumber();
      case HOME, NONE -> 0;
    };
  }

  private Stop stopAhead() {
    return task.route().get(stopNumber());
  }

  /** Whether the load goes no further than where it is carried. */
  boolean isAtLastStop() {
    return stopNumber() == task.route().size() - 1;
  }

  /** The stop at which its robot charges, or to which it is on its way to charge. */
  public Optional<Stop> chargingStop() {
    boolean isOnItsWay =
        switch (state) {
          case ASSIGNED, TO_OBJECT -> task.isDrive();
          case CARRYING -> ending == null;
          case QUEUED, RETURNING, DONE, FAILED, CANCELLED -> false;
        };
    int stop = state == TaskState.CARRYING ? stopNumber() : progress.stop();
    return isOnItsWay
        ? Optional.of(task.route().get(stop)).filter(next -> next.charge() != null)
        : Optional.empty();
  }

  /** For people: where its robots go first. */
  Sentence objectSentence() {
    return task.isDrive() ? task.route().get(progress.stop()).sentence() : object().sentence();
  }

  /** For people: where the load on board is carried. */
  Sentence destinationSentence() {
    return ending == LoadChoice.BACK ? task.start().sentence() : stopAhead().sentence();
  }

  /** The stop at which its robots wait, all of them having come there. */
  public Optional<Stop> waitingStop() {
    return progress.waitingSince() == null
        ? Optional.empty()
        : Optional.of(task.route().get(progress.stop()));
  }

  /**
   * Whether they have waited there for as long as was ordered.
   *
   * @param waited for how long they have, of the fleet's time
   */
  public boolean isWaitOver(Duration waited) {
    return !held
        && trouble == null
        && waitingStop()
            .flatMap(stop -> stop.waitLeft(waited))
            .filter(left -> !left.isPositive())
            .isPresent();
  }

  /** Whether they wait where the load is fetched first, or of a drive where it has come. */
  boolean isToWaitAtObject() {
    return task.isDrive()
        ? task.route().get(progress.stop()).hasWait()
        : progress.stop() == 0 && setDownPlace == null && task.route().getFirst().hasWait();
  }

  /** Whether it is a drive that leads no further than the stop that its robot has not left. */
  boolean isDriveAtLastStop() {
    return task.isDrive() && progress.stop() == task.route().size() - 1;
  }

  /** Whether they wait at the stop to which they bring the load. */
  boolean isToWaitAhead() {
    return stopAhead().hasWait();
  }

  /** Whether its robots, with the load on board, shall stop and set it down. */
  public boolean isStopping() {
    return state == TaskState.CARRYING && ending == LoadChoice.HERE;
  }

  /** What the robot's arm has to do where it is in the mission; empty: nothing. */
  public Optional<ArmTask> armTask(String robot) {
    ArmHandling arm = task.arm();
    if (arm == null
        || assignedRobots.size() != 1
        || isStopping()
        || setDownPlace != null
        || !task.stops().isEmpty()) {
      return Optional.empty();
    }
    return assignedRobot(robot)
        .filter(AssignedRobot::isDriving)
        .flatMap(
            assigned ->
                switch (assigned.phase()) {
                  case TO_OBJECT -> Optional.of(new ArmTask(true, arm.pick()));
                  case TO_GOAL ->
                      Optional.of(
                          new ArmTask(false, ending == LoadChoice.BACK ? arm.pick() : arm.place()));
                  case HOME, NONE -> Optional.empty();
                });
  }

  /**
   * What an arm has to do.
   *
   * @param isPick whether it picks the load up; else it puts it down
   * @param target where, metres, map frame
   */
  public record ArmTask(boolean isPick, Vec2 target) {}

  /** What a person must decide now. */
  public Optional<Question> question() {
    return TroubleRules.question(this);
  }

  /** Whether another robot may take it over: it has one, and that one has not fetched the load. */
  public boolean isExchangeable() {
    return (state == TaskState.ASSIGNED || state == TaskState.TO_OBJECT)
        && assignedRobots.size() == 1
        && assignedRobots.getFirst().isDriving()
        && !held
        && trouble == null
        && chargingStop().isEmpty()
        && task.arm() == null; // it may be in the hand already
  }

  /** Whether the user has seen another state than this one, and does not know it. */
  public boolean isOutdated(MissionEvent.OperatorCommand command) {
    return switch (command) {
      case MissionEvent.Prioritise(String _, int _, Integer seen) ->
          seen != null && seen != task.priority();
      case MissionEvent.Edit(String _, TransportTask _, TransportTask seen) ->
          seen != null && !seen.isOrderedAs(task);
      default -> false;
    };
  }

  public Optional<Objection> objectionTo(MissionEvent.OperatorCommand command) {
    return OperatorCommandRules.objection(this, command);
  }

  /** A command that {@link #objectionTo} speaks against changes nothing. */
  public Step apply(MissionEvent event) {
    return switch (event) {
      case MissionEvent.OperatorCommand command ->
          objectionTo(command).isPresent() ? unchangedStep() : applyCommand(command);
      case MissionEvent.WaitEnded ended -> StopRules.onWaitEnded(this, ended);
      case MissionEvent.ChargeEnded ended -> StopRules.onChargeEnded(this, ended);
      case MissionEvent.LoadFetched fetched ->
          OperatorCommandRules.endLeftLoad(this, Phrase.LOAD_FETCHED.with(fetched.byTask()));
      case MissionEvent.OfRobot e -> isWorkingFor(e.robot()) ? applyRobotEvent(e) : unchangedStep();
    };
  }

  private Step applyCommand(MissionEvent.OperatorCommand command) {
    return switch (command) {
      case MissionEvent.Cancel e -> OperatorCommandRules.cancel(this, e);
      case MissionEvent.Hold e -> OperatorCommandRules.hold(this, e);
      case MissionEvent.Resume e -> OperatorCommandRules.resume(this, e);
      case MissionEvent.Prioritise e -> OperatorCommandRules.prioritise(this, e);
      case MissionEvent.Edit e -> OperatorCommandRules.edit(this, e);
      case MissionEvent.Answer e -> TroubleRules.answer(this, e);
      case MissionEvent.HandOver e -> OperatorCommandRules.handOver(this, e);
      case MissionEvent.GoOn e -> StopRules.goOn(this, e);
      case MissionEvent.MoveLoad e -> OperatorCommandRules.moveLeftLoad(this, e);
      case MissionEvent.RemoveLoad e ->
          OperatorCommandRules.endLeftLoad(this, Phrase.LOAD_REMOVED.with(e.user()));
    };
  }

  private Step applyRobotEvent(MissionEvent.OfRobot event) {
    return switch (event) {
      case MissionEvent.DriveStarted e -> PhaseRules.onDriveStarted(this, e);
      case MissionEvent.PhaseEnded e -> PhaseRules.onPhaseEnded(this, e);
      case MissionEvent.Retasked e -> PhaseRules.onRetasked(this, e);
      case MissionEvent.Exchanged e -> PhaseRules.onExchanged(this, e);
      case MissionEvent.Stopped e -> PhaseRules.onStopped(this, e);
      case MissionEvent.ActFailed e -> TroubleRules.onActFailed(this, e);
      case MissionEvent.RobotLost e -> TroubleRules.onRobotLost(this, e);
      case MissionEvent.RobotFailed e -> TroubleRules.onRobotFailed(this, e);
      case MissionEvent.RobotWithdrawn e -> TroubleRules.onRobotWithdrawn(this, e);
      case MissionEvent.ChargingRequired e -> TroubleRules.onChargingRequired(this, e);
      case MissionEvent.RobotRecovered e -> TroubleRules.onRobotRecovered(this, e);
    };
  }

  private boolean isWorkingFor(String robot) {
    return !state.isEnded() && assignedRobot(robot).filter(c -> !c.unassigned()).isPresent();
  }

  /** The phase that the robot is in for it. */
  Phase phaseOf(String robot) {
    return assignedRobot(robot).map(AssignedRobot::phase).orElse(Phase.NONE);
  }

  /** Whether the robot has ended the phase that it is in for it. */
  boolean phaseHasEnded(String robot) {
    return assignedRobot(robot).filter(AssignedRobot::arrived).isPresent();
  }

  List<MissionCommand> driveCommands(Phase phase) {
    List<MissionCommand> commands = new ArrayList<>();
    for (AssignedRobot c : assignedRobots) {
      if (c.isDriving()) {
        commands.add(new MissionCommand.Drive(c.robot(), phase));
      }
    }
    return commands;
  }

  /** All its robots are let go, and it is in that state then. */
  Step unassignAll(TaskState next, Sentence... history) {
    List<MissionCommand> commands = new ArrayList<>();
    assignedRobots.stream()
        .filter(c -> !c.unassigned())
        .forEach(c -> commands.add(new MissionCommand.Unassign(c.robot())));
    return withAssignedRobots(assignedRobots.stream().map(AssignedRobot::withUnassigned).toList())
        .withProgress(progress.withoutWait())
        .withState(next)
        .withTrouble(null)
        .step(commands, history);
  }

  /** One robot is let go; without the last one the task is done. */
  Step unassign(String robot, Sentence sentence) {
    Mission left = withRobotChanged(robot, AssignedRobot::withUnassigned);
    List<MissionCommand> commands = List.of(new MissionCommand.Unassign(robot));
    return left.assignedRobots.stream().allMatch(AssignedRobot::unassigned)
        ? left.withState(TaskState.DONE).step(commands, sentence, Phrase.DONE.with())
        : left.step(commands, sentence);
  }

  Mission withRobotChanged(String robot, UnaryOperator<AssignedRobot> change) {
    return withAssignedRobots(
        assignedRobots.stream().map(c -> c.robot().equals(robot) ? change.apply(c) : c).toList());
  }

  /** What has ended is not on hold any more and does not end again. */
  Mission withState(TaskState next) {
    return next.isEnded()
        ? new Mission(task, next, assignedRobots, false, null, setDownPlace, null, load, progress)
        : new Mission(
            task, next, assignedRobots, held, ending, setDownPlace, trouble, load, progress);
  }

  Mission withAssignedRobots(List<AssignedRobot> next) {
    return new Mission(task, state, next, held, ending, setDownPlace, trouble, load, progress);
  }

  Mission withPriority(int priority) {
    return new Mission(
        task.withPriority(priority),
        state,
        assignedRobots,
        held,
        ending,
        setDownPlace,
        trouble,
        load,
        progress);
  }

  Mission withPart(OrderPart part) {
    return new Mission(
        task.withPart(part),
        state,
        assignedRobots,
        held,
        ending,
        setDownPlace,
        trouble,
        load,
        progress);
  }

  Mission withOrder(TransportTask order) {
    return new Mission(
        task.withOrder(order),
        state,
        assignedRobots,
        held,
        ending,
        setDownPlace,
        trouble,
        load,
        progress);
  }

  Mission withOwner(String user, long owner) {
    return new Mission(
        task.withOwner(user, owner),
        state,
        assignedRobots,
        held,
        ending,
        setDownPlace,
        trouble,
        load,
        progress);
  }

  Mission withHeld(boolean hold) {
    return new Mission(
        task, state, assignedRobots, hold, ending, setDownPlace, trouble, load, progress);
  }

  Mission withEnding(LoadChoice choice) {
    return new Mission(
        task, state, assignedRobots, held, choice, setDownPlace, trouble, load, progress);
  }

  Mission withLoadAt(@Nullable TaskPlace place) {
    return new Mission(task, state, assignedRobots, held, ending, place, trouble, load, progress);
  }

  Mission withTrouble(@Nullable Trouble next) {
    return new Mission(
        task, state, assignedRobots, held, ending, setDownPlace, next, load, progress);
  }

  Mission withProgress(StopProgress next) {
    return new Mission(
        task, state, assignedRobots, held, ending, setDownPlace, trouble, load, next);
  }

  Step step(List<MissionCommand> commands, Sentence... history) {
    return new Step(this, commands, List.of(history));
  }

  Step unchangedStep() {
    return new Step(this, List.of(), List.of());
  }
}
