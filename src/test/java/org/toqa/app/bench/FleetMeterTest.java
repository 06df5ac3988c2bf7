package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.motion.DriveSpeeds;
import org.toqa.testbed.Hall;

class FleetMeterTest {
  private static final Instant NOON = Instant.parse("2026-06-01T12:00:00Z");
  private static final TaskPlace PLACE = new TaskPlace(Vec2.ZERO, null);

  private final FleetMeter meter = new FleetMeter(() -> NOON);

  @Test
  void robotsThatOverlapAreBelowZeroApart() {
    meter.observe(snapshot(List.of(robot("r1", 0, 0), robot("r2", 0.3, 0.4)), List.of()));
    assertEquals(0.25, meter.report().nearestMetres(), 1e-9); // 0.5 m less 0.1 m and 0.15 m

    meter.observe(snapshot(List.of(robot("r1", 0.3, 0.2), robot("r2", 0.3, 0.4)), List.of()));
    assertEquals(-0.05, meter.report().nearestMetres(), 1e-9); // 0.2 m less 0.25 m

    meter.observe(snapshot(List.of(robot("r1", 9, 9), robot("r2", 0.3, 0.4)), List.of()));
    assertEquals(-0.05, meter.report().nearestMetres(), 1e-9);
  }

  @Test
  void theWaysOfAllRobotsAreAddedUp() {
    meter.observe(snapshot(List.of(robot("r1", 0, 0), robot("r2", 5, 5)), List.of()));
    meter.observe(snapshot(List.of(robot("r1", 0.3, 0.4), robot("r2", 5, 6)), List.of()));
    meter.observe(snapshot(List.of(robot("r1", 0.3, 0.4), robot("r2", 5, 5)), List.of()));

    assertEquals(2.5, meter.report().metresDriven(), 1e-9); // 0.5 m, and 1 m to and fro
  }

  @Test
  void tasksThatWereDoneBeforeDoNotCount() {
    TaskView old = task(1, TaskState.DONE);
    meter.observe(snapshot(List.of(), List.of(old, task(2, TaskState.RETURNING))));
    meter.observe(snapshot(List.of(), List.of(old, task(2, TaskState.DONE))));
    meter.observe(snapshot(List.of(), List.of(task(2, TaskState.DONE), task(3, TaskState.FAILED))));

    assertEquals(1, meter.report().tasksDone());
  }

  private static FleetSnapshot snapshot(List<RobotView> robots, List<TaskView> tasks) {
    return new FleetSnapshot(1, NOON, robots, tasks, 0, List.of(), null, List.of());
  }

  private static TaskView task(long id, TaskState state) {
    TransportTask task =
        new TransportTask(id, "t", 2, PLACE, PLACE, "hall", 0, null, null, "boss", NOON);
    return new TaskView(task, state, false, List.of(), null, null, null, null, NOON);
  }

  /** r1 is 0.2 m wide, any other one 0.3 m. */
  private static RobotView robot(String name, double x, double y) {
    double footprint = name.equals("r1") ? 0.2 : 0.3;
    return Hall.robot(name, RobotState.DRIVING, new Pose(x, y, 0), "127.0.0.1", 7275)
        .withCapabilities(new RobotCapabilities(footprint, DriveSpeeds.DEFAULT, 5));
  }
}
