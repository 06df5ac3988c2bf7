package org.toqa.fleet.dispatch;

import static java.util.stream.Collectors.toMap;
import static java.util.stream.Collectors.toSet;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.Decision;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.floor.FloorMessage.Move;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskState;
import org.toqa.wording.Sentence;

/**
 * Tasks that robots have and that other robots may still take over: which ones, and what an
 * allocator's decisions about them mean. Confined to one agent.
 */
final class TaskExchanges {
  /**
   * A task that changed robots stays with the new one for so long, so that none goes to and fro.
   */
  private static final Duration SETTLED_AFTER = Duration.ofSeconds(10);

  private final Map<Long, Instant> exchanged = new HashMap<>();

  /** The tasks of a floor whose loads are not picked up. */
  List<GivenTask> exchangeableTasks(List<TaskView> missions, List<RobotView> robots, Instant now) {
    exchanged.values().removeIf(at -> at.plus(SETTLED_AFTER).isBefore(now));
    Map<String, RobotView> byName = robots.stream().collect(toMap(RobotView::name, r -> r));
    List<GivenTask> given = new ArrayList<>();
    for (TaskView task : missions) {
      if (isExchangeable(task) && isDrivingToLoad(task, byName.get(task.robots().getFirst()))) {
        given.add(
            new GivenTask(
                new ChosenRobots(robots)
                    .named(TaskQueue.job(task.task(), task.object(), task.progress())),
                task.robots().getFirst()));
      }
    }
    return given;
  }

  private boolean isExchangeable(TaskView task) {
    return (task.state() == TaskState.ASSIGNED || task.state() == TaskState.TO_OBJECT)
        && task.robots().size() == 1
        && !task.held()
        && !task.isWaitingAtStop()
        && task.needs() == null
        && !exchanged.containsKey(task.id());
  }

  private static boolean isDrivingToLoad(TaskView task, @Nullable RobotView robot) {
    return robot != null
        && !robot.work().held()
        && (robot.state() == RobotState.DRIVING || robot.state() == RobotState.IDLE)
        && robot.work().phase() == Phase.TO_OBJECT
        && Long.valueOf(task.id()).equals(robot.work().task());
  }

  /**
   * The decisions that take tasks from robots; none where a robot that gets one is not free by
   * then.
   *
   * @param missions of the floor
   * @param free robots
   */
  List<Move> moves(
      List<Decision> decisions, List<TaskView> missions, Set<String> free, Instant now) {
    Map<Long, TaskView> byId = missions.stream().collect(toMap(TaskView::id, t -> t));
    List<Move> moves = new ArrayList<>();
    for (Decision decision : decisions) {
      TaskView task = byId.get(decision.task());
      if (decision instanceof Decision.Assigned(long id, List<String> chosen, Sentence why)
          && task != null
          && isExchangeable(task)) {
        moves.add(new Move(id, task.robots().getFirst(), chosen.getFirst(), why));
      }
    }
    Set<String> givers = moves.stream().map(Move::from).collect(toSet());
    if (!moves.stream().allMatch(m -> free.contains(m.to()) || givers.contains(m.to()))) {
      return List.of();
    }
    moves.forEach(m -> exchanged.put(m.task(), now));
    return moves;
  }
}
