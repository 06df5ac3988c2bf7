package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.traffic.RoadGraph;
import org.toqa.wording.Phrase;

class GoalRecorderTest {
  private static final Instant NOON = Instant.parse("2026-06-01T12:00:00Z");

  /** Cells of 1 m; row 0 is at the top, so y = 2.5 is in it. */
  private final GoalRecorder recorder =
      new GoalRecorder(new RoadGraph(OccupancyGrid.parse("......", "......", "......")));

  @Test
  void robotsBeginWhereTheyWereSeenFirstAndGoWhereTheirTasksSendThem() {
    observe(
        List.of(robot("r1", 0.4, 2.6, Math.PI / 2 + 0.2, 1L), robot("r2", 3, 0.5, -0.3, 2L)),
        List.of(task(1, TaskState.TO_OBJECT, "r1", 2, 4), task(2, TaskState.CARRYING, "r2", 1, 5)));
    observe(
        List.of(robot("r1", 2.5, 2.5, 0, 1L), robot("r2", 5.5, 2.5, 0, 2L)),
        List.of(task(1, TaskState.CARRYING, "r1", 2, 4), task(2, TaskState.RETURNING, "r2", 1, 5)));
    observe(
        List.of(robot("r1", 4.5, 2.5, 0, null), robot("r2", 5.5, 2.5, 0, 3L)),
        List.of(task(1, TaskState.DONE, "r1", 2, 4), task(3, TaskState.ASSIGNED, "r2", 0, 3)));

    assertEquals(List.of("0,0,N 2,0 4,0", "3,2,E 5,0 0,0 3,0"), lines());
  }

  @Test
  void taskThatAnotherRobotTakesOverSendsTheFirstNowhere() {
    observe(
        List.of(robot("r1", 0.5, 2.5, 0, 1L), robot("r2", 0.5, 0.5, 0, null)),
        List.of(task(1, TaskState.TO_OBJECT, "r1", 2, 4)));
    observe(
        List.of(robot("r1", 0.5, 2.5, 0, 2L), robot("r2", 0.5, 0.5, 0, 1L)),
        List.of(task(1, TaskState.TO_OBJECT, "r2", 2, 4), task(2, TaskState.ASSIGNED, "r1", 1, 3)));

    assertEquals(List.of("0,0,E 1,0 3,0", "0,2,E 2,0 4,0"), lines());
  }

  /** Only one of them can begin there. */
  @Test
  void ofTwoRobotsInACellOneBeginsBesideIt() {
    observe(
        List.of(robot("r1", 5.1, 2.5, 0, null), robot("r2", 5.7, 2.5, Math.PI, null)), List.of());

    assertEquals(List.of("5,0,E", "4,0,W"), lines().stream().sorted().toList().reversed());
  }

  private List<String> lines() {
    return recorder.goals().stream().map(RobotGoals::line).toList();
  }

  private void observe(List<RobotView> robots, List<TaskView> tasks) {
    recorder.observe(
        new FleetSnapshot(
            1, NOON, robots, tasks, 0, List.of(), null, Map.of(), Map.of(), List.of()));
  }

  /** From the middle of a cell of row 0 to another one's. */
  private static TaskView task(long id, TaskState state, String robot, int start, int goal) {
    TransportTask task =
        new TransportTask(
            id, "t", 2, place(start), place(goal), "hall", 0, null, null, "boss", NOON);
    return Views.task(task, state, false, List.of(robot), null, null, false, null, null, NOON);
  }

  private static TaskPlace place(int column) {
    return new TaskPlace(new Vec2(column + 0.5, 2.5), null);
  }

  private static RobotView robot(
      String name, double x, double y, double theta, @Nullable Long task) {
    return Hall.robot(name, RobotState.DRIVING, new Pose(x, y, theta), "127.0.0.1", 7275)
        .withWork(
            new RobotView.Work(task, Phase.NONE, false, null, Phrase.LOOKING_FOR_ROBOT.with()));
  }
}
