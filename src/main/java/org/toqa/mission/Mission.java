package org.toqa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A task's life: a pure state machine over the three phases (Tanta, "Task phases").
 *
 * <p>Phase 2 starts when all its robots are at the object; in phase 3 each drives home alone. The
 * task is DONE when the last of its robots has parked, failed or taken another task. A robot that
 * fails before it has the load gives the task back to the queue; with the load on board a person is
 * asked. Nothing here knows a clock, a store or a socket: {@link #on} answers the next state, what
 * to do once it is stored, and what the history says.
 *
 * @param held whether a person has put it on hold
 * @param ending what becomes of the load on board, once the task was cancelled
 * @param setDown where the load was fetched last, or stands, if that is neither its start nor its
 *     goal
 * @param trouble what keeps a robot from going on, if anything
 */
public record Mission(
    TransportTask task,
    TaskState state,
    List<Carrier> carriers,
    boolean held,
    @Nullable LoadChoice ending,
    @Nullable TaskPlace setDown,
    @Nullable Trouble trouble) {

  /**
   * @param history sentences for the task's history; empty when the event changed nothing
   */
  public record Step(Mission mission, List<MissionCommand> commands, List<Sentence> history) {
    public Step {
      commands = List.copyOf(commands);
      history = List.copyOf(history);
    }

    public boolean changed() {
      return !history.isEmpty();
    }
  }

  public Mission {
    carriers = List.copyOf(carriers);
  }

  /** A task that has no robots yet. */
  public static Mission queued(TransportTask task) {
    return new Mission(task, TaskState.QUEUED, List.of(), false, null, null, null);
  }

  /** Robots were chosen for a queued task. */
  public Step assign(List<String> robots, Sentence why) {
    Mission mission =
        by(robots.stream().map(Carrier::chosen).toList()).in(TaskState.ASSIGNED).troubled(null);
    return mission.step(mission.driveAll(1), Phrase.GIVEN_TO.with(Sentence.names(robots), why));
  }

  public long id() {
    return task.id();
  }

  public Optional<Carrier> carrier(String robot) {
    return carriers.stream().filter(c -> c.robot().equals(robot)).findFirst();
  }

  /** The names, in the order they were chosen. */
  public List<String> robots() {
    return state == TaskState.QUEUED ? List.of() : carriers.stream().map(Carrier::robot).toList();
  }

  /** Where the load is fetched. */
  public TaskPlace object() {
    return setDown != null ? setDown : task.start();
  }

  /**
   * Where the load stands if that is neither its start nor its goal; null too while it is on its
   * way.
   */
  public @Nullable TaskPlace loadAt() {
    if (state != TaskState.CARRYING) {
      return setDown;
    }
    return trouble == null ? null : trouble.place();
  }

  /** Where the load on board is carried. */
  public TaskPlace destination() {
    return ending == LoadChoice.BACK ? task.start() : task.goal();
  }

  /** Whether its robots, with the load on board, shall come to a stand and set it down. */
  public boolean isStopping() {
    return state == TaskState.CARRYING && ending == LoadChoice.HERE;
  }

  /** What a person must decide now. */
  public Optional<Question> question() {
    return TroubleRules.question(this);
  }

  /** Whether another robot may take it over: it has one, and that one has not fetched the load. */
  public boolean isExchangeable() {
    return (state == TaskState.ASSIGNED || state == TaskState.TO_OBJECT)
        && carriers.size() == 1
        && carriers.getFirst().isDriving()
        && !held
        && trouble == null;
  }

  public Optional<Objection> objectionTo(MissionEvent.Wish wish) {
    return WishRules.objection(this, wish);
  }

  /** A wish that {@link #objectionTo} speaks against changes nothing. */
  public Step on(MissionEvent event) {
    return switch (event) {
      case MissionEvent.Wish wish -> objectionTo(wish).isPresent() ? unchanged() : wished(wish);
      case MissionEvent.OfRobot e -> isWorkingFor(e.robot()) ? happened(e) : unchanged();
    };
  }

  private Step wished(MissionEvent.Wish wish) {
    return switch (wish) {
      case MissionEvent.Cancel e -> WishRules.cancel(this, e);
      case MissionEvent.Hold e -> WishRules.hold(this, e);
      case MissionEvent.Resume e -> WishRules.resume(this, e);
      case MissionEvent.Prioritise e -> WishRules.prioritise(this, e);
      case MissionEvent.Answer e -> TroubleRules.answered(this, e);
    };
  }

  private Step happened(MissionEvent.OfRobot event) {
    return switch (event) {
      case MissionEvent.DriveStarted e -> PhaseRules.started(this, e);
      case MissionEvent.PhaseEnded e -> PhaseRules.ended(this, e);
      case MissionEvent.Retasked e -> PhaseRules.retasked(this, e);
      case MissionEvent.Exchanged e -> PhaseRules.exchanged(this, e);
      case MissionEvent.Stopped e -> PhaseRules.stopped(this, e);
      case MissionEvent.RobotLost e -> TroubleRules.lost(this, e);
      case MissionEvent.RobotFailed e -> TroubleRules.failed(this, e);
      case MissionEvent.RobotWithdrawn e -> TroubleRules.withdrawn(this, e);
      case MissionEvent.MustCharge e -> TroubleRules.charges(this, e);
      case MissionEvent.RobotBack e -> TroubleRules.back(this, e);
    };
  }

  private boolean isWorkingFor(String robot) {
    return !state.isEnded() && carrier(robot).filter(c -> !c.released()).isPresent();
  }

  /** The phase that the robot is in for it. */
  int phaseOf(String robot) {
    return carrier(robot).map(Carrier::phase).orElse(0);
  }

  List<MissionCommand> driveAll(int phase) {
    List<MissionCommand> commands = new ArrayList<>();
    for (Carrier c : carriers) {
      if (c.isDriving()) {
        commands.add(new MissionCommand.Drive(c.robot(), phase));
      }
    }
    return commands;
  }

  /** All its robots are let go, and it is in that state then. */
  Step letAllGo(TaskState next, Sentence... history) {
    List<MissionCommand> commands = new ArrayList<>();
    carriers.stream()
        .filter(c -> !c.released())
        .forEach(c -> commands.add(new MissionCommand.LetGo(c.robot())));
    return by(carriers.stream().map(Carrier::letGo).toList())
        .in(next)
        .troubled(null)
        .step(commands, history);
  }

  /** One robot is let go; without the last one the task is done. */
  Step letGo(String robot, Sentence sentence) {
    Mission left = replace(robot, Carrier::letGo);
    List<MissionCommand> commands = List.of(new MissionCommand.LetGo(robot));
    return left.carriers.stream().allMatch(Carrier::released)
        ? left.in(TaskState.DONE).step(commands, sentence, Phrase.DONE.with())
        : left.step(commands, sentence);
  }

  Mission replace(String robot, UnaryOperator<Carrier> change) {
    return by(carriers.stream().map(c -> c.robot().equals(robot) ? change.apply(c) : c).toList());
  }

  /** What has ended is not on hold any more and ends in no other way. */
  Mission in(TaskState next) {
    return next.isEnded()
        ? new Mission(task, next, carriers, false, null, setDown, null)
        : new Mission(task, next, carriers, held, ending, setDown, trouble);
  }

  Mission by(List<Carrier> next) {
    return new Mission(task, state, next, held, ending, setDown, trouble);
  }

  Mission prioritised(int priority) {
    return new Mission(
        task.withPriority(priority), state, carriers, held, ending, setDown, trouble);
  }

  Mission onHold(boolean hold) {
    return new Mission(task, state, carriers, hold, ending, setDown, trouble);
  }

  Mission ending(LoadChoice choice) {
    return new Mission(task, state, carriers, held, choice, setDown, trouble);
  }

  Mission withLoadAt(@Nullable TaskPlace place) {
    return new Mission(task, state, carriers, held, ending, place, trouble);
  }

  Mission troubled(@Nullable Trouble next) {
    return new Mission(task, state, carriers, held, ending, setDown, next);
  }

  Step step(List<MissionCommand> commands, Sentence... history) {
    return new Step(this, commands, List.of(history));
  }

  Step unchanged() {
    return new Step(this, List.of(), List.of());
  }
}
