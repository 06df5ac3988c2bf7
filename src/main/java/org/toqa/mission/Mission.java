package org.toqa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * A task that robots have: a pure state machine over the three phases (Tanta, "Task phases").
 *
 * <p>Phase 2 starts when all its robots are at the object; in phase 3 each drives home alone. The
 * task is DONE when the last of its robots has parked or taken another task. Nothing here knows a
 * clock, a store or a socket: {@link #on} answers the next state, what to do once it is stored, and
 * what the history says.
 */
public record Mission(TransportTask task, TaskState state, List<Carrier> carriers) {

  /**
   * @param history sentences for the task's history; empty when the event changed nothing
   */
  public record Step(Mission mission, List<MissionCommand> commands, List<String> history) {
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

  /** Robots were chosen for a queued task. */
  public static Step assign(TransportTask task, List<String> robots, String why) {
    List<Carrier> carriers = robots.stream().map(Carrier::chosen).toList();
    Mission mission = new Mission(task, TaskState.ASSIGNED, carriers);
    return new Step(
        mission,
        mission.driveAll(1),
        List.of("Given to " + String.join(", ", robots) + ": " + why));
  }

  public long id() {
    return task.id();
  }

  public Optional<Carrier> carrier(String robot) {
    return carriers.stream().filter(c -> c.robot().equals(robot)).findFirst();
  }

  /** The names, in the order they were chosen. */
  public List<String> robots() {
    return carriers.stream().map(Carrier::robot).toList();
  }

  public Step on(MissionEvent event) {
    Optional<Carrier> carrier = carrier(event.robot()).filter(c -> !c.released());
    if (state.isEnded() || carrier.isEmpty()) {
      return unchanged();
    }
    return switch (event) {
      case MissionEvent.DriveStarted e -> started(e);
      case MissionEvent.PhaseEnded e ->
          carrier.get().phase() == e.phase() && !carrier.get().arrived()
              ? phaseEnded(e)
              : unchanged();
      case MissionEvent.Retasked e ->
          carrier.get().phase() == 3
              ? letGo(e.robot(), e.robot() + " took another task on its way home")
              : unchanged();
    };
  }

  private Step started(MissionEvent.DriveStarted event) {
    if (state != TaskState.ASSIGNED || event.phase() != 1) {
      return unchanged();
    }
    return new Step(
        with(TaskState.TO_OBJECT, carriers),
        List.of(),
        List.of(event.robot() + " set out for the load"));
  }

  private Step phaseEnded(MissionEvent.PhaseEnded event) {
    List<Carrier> arrived = replace(event.robot(), Carrier::arrivedAtEnd);
    return switch (event.phase()) {
      case 1 ->
          together(
              arrived,
              TaskState.CARRYING,
              2,
              event.robot() + " is at the load",
              "Picked up at " + task.start().text());
      case 2 ->
          together(
              arrived,
              TaskState.RETURNING,
              3,
              event.robot() + " is at the goal",
              "Delivered at " + task.goal().text());
      default -> letGo(event.robot(), event.robot() + " has parked");
    };
  }

  /** Goes on to the next phase when the last robot has arrived. */
  private Step together(List<Carrier> arrived, TaskState next, int phase, String one, String all) {
    boolean complete = arrived.stream().allMatch(c -> c.arrived() || c.released());
    if (!complete) {
      TaskState now = state == TaskState.ASSIGNED ? TaskState.TO_OBJECT : state;
      return new Step(with(now, arrived), List.of(), List.of(one));
    }
    Mission mission =
        with(next, arrived.stream().map(c -> c.released() ? c : c.inPhase(phase)).toList());
    List<String> history = carriers.size() == 1 ? List.of(all) : List.of(one, all);
    return new Step(mission, mission.driveAll(phase), history);
  }

  private Step letGo(String robot, String sentence) {
    List<Carrier> left = replace(robot, Carrier::letGo);
    boolean last = left.stream().allMatch(Carrier::released);
    List<String> history = last ? List.of(sentence, "Done") : List.of(sentence);
    return new Step(
        with(last ? TaskState.DONE : state, left),
        List.of(new MissionCommand.LetGo(robot)),
        history);
  }

  private List<MissionCommand> driveAll(int phase) {
    List<MissionCommand> commands = new ArrayList<>();
    for (Carrier c : carriers) {
      if (c.isDriving()) {
        commands.add(new MissionCommand.Drive(c.robot(), phase));
      }
    }
    return commands;
  }

  private List<Carrier> replace(String robot, UnaryOperator<Carrier> change) {
    return carriers.stream().map(c -> c.robot().equals(robot) ? change.apply(c) : c).toList();
  }

  private Mission with(TaskState next, List<Carrier> nextCarriers) {
    return new Mission(task, next, nextCarriers);
  }

  private Step unchanged() {
    return new Step(this, List.of(), List.of());
  }
}
