package org.toqa.app.bench;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;

/**
 * Keeps robots busy: a task brings its robot to two goals, the load's place and its destination,
 * and when it has reached both, the next task begins. A robot that has reached all its goals stays
 * where its last task leaves it.
 */
final class GoalDispatcher {
  /** Kilograms; without a load it would be a drive, which nothing is fetched for. */
  private static final double LOAD = 1;

  private final GoalSource source;
  private final Function<Cell, Vec2> centre;
  private final String floor;
  private final Instant createdAt;
  private final Listener listener;
  private final Cell[] places;
  private final int[] reachedOfTask;

  /** By task, the robot that has it. */
  private final Map<Long, Integer> robots = new HashMap<>();

  private long lastTask;
  private int goals;

  /** Is told what follows. */
  interface Listener {
    /** The robot shall carry out this task next. */
    void taskMade(int robot, Mission mission);

    /** The robot has another goal. */
    void goalChanged(int robot);

    /**
     * @param reason why it does not get on; null: it does
     */
    void waits(int robot, @Nullable String reason);
  }

  /**
   * @param starts a cell a robot
   * @param floor its name
   */
  GoalDispatcher(
      GoalSource source,
      List<Cell> starts,
      Function<Cell, Vec2> centre,
      String floor,
      Instant createdAt,
      Listener listener) {
    this.source = source;
    this.centre = centre;
    this.floor = floor;
    this.createdAt = createdAt;
    this.listener = listener;
    places = starts.toArray(Cell[]::new);
    reachedOfTask = new int[places.length];
  }

  /** Each robot gets its first two goals: the first ones are drawn for all, then the second. */
  void begin() {
    List<Optional<Cell>> first = new ArrayList<>();
    for (int robot = 0; robot < places.length; robot++) {
      first.add(source.next(robot, places[robot]));
    }
    for (int robot = 0; robot < places.length; robot++) {
      int index = robot;
      first.get(robot).ifPresent(start -> beginTask(index, start));
    }
  }

  /**
   * @param start its first goal; also its second, which then does not count, where there is none
   */
  private void beginTask(int robot, Cell start) {
    Optional<Cell> second = source.next(robot, start);
    Cell goal = second.orElse(start);
    long id = ++lastTask;
    robots.put(id, robot);
    reachedOfTask[robot] = second.isPresent() ? 0 : 1;
    places[robot] = goal;
    listener.goalChanged(robot);
    listener.taskMade(
        robot,
        Mission.queued(
            new TransportTask(
                id,
                "task " + id,
                LOAD,
                new TaskPlace(centre.apply(start), null),
                new TaskPlace(centre.apply(goal), null),
                floor,
                0,
                null,
                null,
                "bench",
                createdAt)));
  }

  /** The floor could not begin the task: it is asked again. */
  void repeat(Mission mission) {
    Integer robot = robots.get(mission.id());
    if (robot != null) {
      listener.taskMade(robot, mission);
    }
  }

  /** The floor says how its task is. */
  void update(TaskView task) {
    Integer robot = robots.get(task.id());
    if (robot == null) {
      return;
    }
    int reached =
        switch (task.state()) {
          case CARRYING -> 1;
          case RETURNING, DONE -> 2;
          default -> 0;
        };
    listener.waits(robot, task.waitingFor() == null ? null : task.waitingFor().english());
    if (reached > reachedOfTask[robot]) {
      goals += reached - reachedOfTask[robot];
      reachedOfTask[robot] = reached;
      listener.goalChanged(robot);
    }
    if (reached == 2) {
      robots.remove(task.id());
      source.next(robot, places[robot]).ifPresent(start -> beginTask(robot, start));
    }
  }

  /** How many were reached. */
  int goals() {
    return goals;
  }
}
