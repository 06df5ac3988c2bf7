package org.toqa.app.bench;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.mission.TaskPlace;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.RoadGraph;

/**
 * Keeps where the robots of a fleet are at first and where its tasks send them from then on, so
 * that a floor alone can be driven from the same places to the same goals.
 *
 * <p>A robot between cells is said to be in the one that its middle is in; of two in one cell the
 * second is said to be in the nearest that is free.
 */
final class GoalRecorder {
  private final RoadGraph roads;
  private final Map<String, Recorded> robots = new LinkedHashMap<>();
  private final Set<Cell> taken = new HashSet<>();

  /**
   * What is known of a robot.
   *
   * @param errands in the order in which it was given them
   */
  private record Recorded(GridPose start, Deque<Errand> errands) {
    RobotGoals goals() {
      return new RobotGoals(
          start, errands.stream().flatMap(errand -> errand.goals().stream()).toList());
    }
  }

  /** Where a task sends a robot. */
  private record Errand(long task, List<Cell> goals) {}

  /**
   * @param roads of the only floor
   */
  GoalRecorder(RoadGraph roads) {
    this.roads = roads;
  }

  /** Takes a snapshot, each one after those before it. */
  void observe(FleetSnapshot snapshot) {
    Map<Long, TaskView> tasks =
        snapshot.tasks().stream().collect(Collectors.toMap(TaskView::id, Function.identity()));
    for (RobotView robot : snapshot.robots()) {
      Pose pose = robot.telemetry().pose();
      if (pose != null && !robots.containsKey(robot.name())) {
        robots.put(robot.name(), new Recorded(start(pose), new ArrayDeque<>()));
      }
      Recorded recorded = robots.get(robot.name());
      TaskView task = robot.work().task() == null ? null : tasks.get(robot.work().task());
      if (recorded != null && task != null) {
        record(recorded.errands(), robot.name(), task, tasks);
      }
    }
  }

  /** The robots in the order in which they were seen first. */
  List<RobotGoals> goals() {
    return robots.values().stream().map(Recorded::goals).toList();
  }

  private void record(
      Deque<Errand> errands, String robot, TaskView task, Map<Long, TaskView> tasks) {
    Errand last = errands.peekLast();
    if (last != null && last.task() == task.id()) {
      return;
    }
    if (last != null && isTakenAway(robot, tasks.get(last.task()))) {
      errands.removeLast();
    }
    List<Cell> goals =
        switch (task.state()) {
          case QUEUED, ASSIGNED, TO_OBJECT ->
              List.of(cell(task.object()), cell(task.task().goal()));
          case CARRYING -> List.of(cell(task.task().goal()));
          case RETURNING, DONE, FAILED, CANCELLED -> List.of();
        };
    errands.addLast(new Errand(task.id(), goals));
  }

  /** Whether the task goes on without the robot: what it was sent to is another one's now. */
  private static boolean isTakenAway(String robot, @Nullable TaskView task) {
    return task != null && !task.state().isEnded() && !task.robots().contains(robot);
  }

  private GridPose start(Pose pose) {
    int quarters = Math.toIntExact(Math.round(pose.theta() / (Math.PI / 2)));
    return new GridPose(freeCell(cell(pose.position())), Heading.EAST.turned(2 * quarters));
  }

  /** The nearest where no robot was seen first. */
  private Cell freeCell(Cell near) {
    Cell[] found = {near};
    roads.visitByDistance(
        roads.vertex(near),
        (vertex, _) -> {
          found[0] = roads.cell(vertex);
          return taken.contains(found[0]);
        });
    taken.add(found[0]);
    return found[0];
  }

  private Cell cell(TaskPlace place) {
    return cell(place.position());
  }

  private Cell cell(Vec2 position) {
    return roads.grid().cellAt(position);
  }
}
