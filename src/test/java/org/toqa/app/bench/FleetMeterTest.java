package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.motion.DriveKind;
import org.toqa.motion.DriveSpeeds;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;

@Tag("full")
class FleetMeterTest {
  private static final Instant NOON = Instant.parse("2026-06-01T12:00:00Z");
  private static final TaskPlace PLACE = new TaskPlace(Vec2.ZERO, null);

  private final ClearanceJudge truth =
      new ClearanceJudge(OccupancyGrid.parse("....", "....", "...."));
  private final FleetMeter meter = new FleetMeter(() -> NOON, Map.of("hall", truth));

  /** What robots say of themselves is far from each other and from walls: nobody asks them. */
  @Test
  void bodiesThatTouchFailWhateverRobotsReport() {
    meter.observe(snapshot(List.of(robot("r1", 1, 1), robot("r2", 3, 1)), List.of()));
    assertEquals(List.of("nothing was seen of where two robots on hall really were"), failures(0));

    judge(Body.disc("r1", new Vec2(1, 1), 0.1), Body.disc("r2", new Vec2(3, 1), 0.15));
    assertEquals(List.of(), failures(0));
    assertEquals(1.75, meter.report().trueNearestMetres()); // 2 m less 0.1 m and 0.15 m
    // r2 is 1 m from the south
    assertEquals(0.85, Objects.requireNonNull(meter.report().trueWallMetres()), 1e-12);
    assertEquals(1, meter.report().trueSamples());

    judge(Body.disc("r1", new Vec2(1, 1), 0.1), Body.disc("r2", new Vec2(1.2, 1), 0.15));
    assertEquals(List.of("on hall, r2 was -0.0500 m from r1 at 0.00 s"), failures(0));
    assertEquals(1.75, meter.report().nearestMetres(), 1e-12);
  }

  @Test
  void bodyThatTouchesAWallFails() {
    judge(Body.disc("r1", new Vec2(0.1, 1), 0.15), Body.disc("r2", new Vec2(2, 1), 0.15));
    assertEquals(List.of("on hall, r1 was -0.0500 m from wall (-1,1) at 0.00 s"), failures(0));
  }

  @Test
  void paceBelowTheLeastFails() {
    judge(Body.disc("r1", new Vec2(1, 1), 0.1), Body.disc("r2", new Vec2(3, 1), 0.15));
    // the fleet's clock stands still
    assertEquals(List.of("the pace 0.0 is below 0.5"), failures(0.5));
    assertEquals(List.of(), failures(0));
  }

  private void judge(Body... bodies) {
    truth.judge(Duration.ZERO, List.of(bodies));
  }

  private List<String> failures(double leastPace) {
    return FleetBench.failures(meter.report(), Map.of("hall", truth), leastPace);
  }

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
  void robotsOfTwoFloorsAreNotNearEachOther() {
    RobotView above = robot("r2", 0.3, 0.4);
    RobotView below = above.withRecord(above.record().movedTo("cellar"));
    meter.observe(snapshot(List.of(robot("r1", 0.3, 0.4), below), List.of()));
    assertEquals(Double.POSITIVE_INFINITY, meter.report().nearestMetres());
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
    return new FleetSnapshot(
        1, NOON, robots, tasks, 0, List.of(), null, Map.of(), Map.of(), List.of());
  }

  private static TaskView task(long id, TaskState state) {
    TransportTask task =
        new TransportTask(id, "t", 2, PLACE, PLACE, "hall", 0, null, null, "boss", NOON);
    return Views.task(task, state, false, List.of(), null, null, false, null, null, NOON);
  }

  /** r1 is 0.2 m wide, any other one 0.3 m. */
  private static RobotView robot(String name, double x, double y) {
    double footprint = name.equals("r1") ? 0.2 : 0.3;
    return Hall.robot(name, RobotState.DRIVING, new Pose(x, y, 0), "127.0.0.1", 7275)
        .withCapabilities(
            new RobotCapabilities(footprint, DriveSpeeds.DEFAULT, 5, 0.8, DriveKind.OMNI));
  }
}
