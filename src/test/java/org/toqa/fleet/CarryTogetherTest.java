package org.toqa.fleet;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.fleet.FloorView.HoldPoint;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.sim.SimulatedFloor;

/**
 * Real daemons over simulated bodies carry heavy loads, from the order to the drive home. That no
 * body meets another one or a wall is judged by {@link LiveFloor}, where they really are.
 */
@Tag("full")
class CarryTogetherTest {
  private static final double SPEED = 200;
  private static final double SIZE = 0.3;

  /** Cells of 0.3 m: a hall of 12 m x 4.2 m. */
  private static final String[] HALL = hall(40, 14);

  @TempDir private Path folder;
  private @Nullable LiveFloor opened;

  @AfterEach
  void close() throws Exception {
    live().close();
  }

  @Test
  @Timeout(300)
  void twoRobotsCarryWhatIsTooHeavyForOne() throws Exception {
    open(2);
    long task = order(8);
    FleetSnapshot carrying =
        live().await(view -> LiveFloor.isInState(view, task, TaskState.CARRYING));
    assertEquals(2, LiveFloor.task(carrying, task).robots().size());
    untilDone(task);
  }

  @Test
  @Timeout(300)
  void threeRobotsCarryWhatIsTooHeavyForTwo() throws Exception {
    open(3);
    long task = order(12);
    FleetSnapshot carrying =
        live().await(view -> LiveFloor.isInState(view, task, TaskState.CARRYING));
    assertEquals(3, LiveFloor.task(carrying, task).robots().size());
    for (HoldPoint point : awaitMeasuredShares()) {
      assertEquals(4, point.share());
      assertEquals(point.share(), requireNonNull(point.measured()), 0.4, point::toString);
    }
    untilDone(task);
  }

  @Test
  @Timeout(300)
  void threeRobotsCarryALoadFromStopToStopAndBack() throws Exception {
    open(3);
    long task =
        live()
            .submit(
                new TaskOrder("gearbox", 12, station("A"), station("A"), null, 0, null, null)
                    .along(
                        List.of(
                            new StopOrder(station("A"), false, Duration.ofSeconds(5)),
                            new StopOrder(station("B"), true, null),
                            new StopOrder(station("C"), false, null),
                            new StopOrder(station("A"), false, null))));
    FleetSnapshot waiting =
        live()
            .await(
                view ->
                    LiveFloor.isInState(view, task, TaskState.CARRYING)
                        && LiveFloor.task(view, task).isWaitingAtStop());
    live().pass(Duration.ofMinutes(2));
    for (RobotView before : waiting.robots()) {
      Pose stood = requireNonNull(before.telemetry().pose());
      Pose stands = requireNonNull(robot(before.name()).telemetry().pose());
      assertTrue(stands.distanceTo(stood) < 0.01, before.name() + ": " + stands);
    }
    live().fleet.commandTask(task, new MissionEvent.GoOn("Clara", 1));
    untilDone(task);
  }

  private static Where station(String name) {
    return new Where.Station(name);
  }

  /** It takes itself to be 0.07 m from where it is, and so stands that much beside its place. */
  @Test
  @Timeout(300)
  void robotThatStandsOutOfItsPlaceBearsAnotherShare() throws Exception {
    open(3);
    Pose where = requireNonNull(robot("r3").telemetry().pose());
    live()
        .fleet
        .locateRobot("r3", new Pose(where.x() + 0.05, where.y() + 0.05, where.theta()), "Max")
        .toCompletableFuture()
        .get(10, TimeUnit.SECONDS);
    order(12);
    List<HoldPoint> points = awaitMeasuredShares();
    double sum = points.stream().mapToDouble(point -> requireNonNull(point.measured())).sum();
    assertEquals(12, sum, 0.3); // each is rounded
    assertTrue(
        points.stream()
            .anyMatch(point -> Math.abs(requireNonNull(point.measured()) - point.share()) > 0.6),
        points::toString);
  }

  private RobotView robot(String name) {
    return live().fleet.snapshots().latest().robots().stream()
        .filter(robot -> robot.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  private List<HoldPoint> awaitMeasuredShares() throws InterruptedException {
    return heldPoints(
        live()
            .await(
                view -> {
                  List<HoldPoint> points = heldPoints(view);
                  return !points.isEmpty() && points.stream().allMatch(p -> p.measured() != null);
                }));
  }

  private static List<HoldPoint> heldPoints(FleetSnapshot view) {
    return view.floors().getFirst().heldLoads().stream()
        .flatMap(load -> load.points().stream())
        .toList();
  }

  /** They take wide corners, and are allowed to be farther off their places. */
  @Test
  @Timeout(300)
  void threeRobotsThatCannotGoSidewaysCarryTogether() throws Exception {
    open(3, DriveKind.DIFFERENTIAL);
    untilDone(live().submit(12, "A", "C"));
  }

  /** Longer than a robot may stand without a word. */
  @Test
  @Timeout(300)
  void aGroupThatStandsSinceAPersonHoldsAFollowerIsNoStandstill() throws Exception {
    open(2);
    long task = order(8);
    FleetSnapshot carrying =
        live()
            .await(
                view ->
                    LiveFloor.isInState(view, task, TaskState.CARRYING)
                        && view.robots().stream().allMatch(r -> r.state() == RobotState.DRIVING));
    String follower = LiveFloor.task(carrying, task).robots().getLast();
    var held = live().fleet.holdRobot(follower, "Max").toCompletableFuture();
    long until = live().clock.nanos() + Duration.ofSeconds(60).toNanos();

    live()
        .await(
            view -> {
              assertEquals(List.of(), view.floors().getFirst().standstills());
              String waits = String.valueOf(LiveFloor.task(view, task).waitingFor());
              assertFalse(waits.contains(".;"), waits);
              return held.isDone() && live().clock.nanos() > until;
            });

    live().fleet.resumeRobot(follower, "Max");
    untilDone(task);
  }

  /** No follower is off its place by more than the tolerance meanwhile. */
  private void untilDone(long task) throws Exception {
    live()
        .await(
            view -> {
              assertEquals(List.of(), outOfPlace(view));
              return LiveFloor.isInState(view, task, TaskState.DONE);
            });
    assertTrue(live().hasSeenCarriedLoad());
  }

  private static List<String> outOfPlace(FleetSnapshot view) {
    return view.robots().stream()
        .flatMap(r -> r.telemetry().errors().stream())
        .filter(fault -> fault.code().equals("OUT_OF_PLACE"))
        .map(Fault::text)
        .toList();
  }

  private long order(double load) throws Exception {
    return live().submit(load, "A", "B");
  }

  private LiveFloor live() {
    return Objects.requireNonNull(opened);
  }

  private void open(int count) throws Exception {
    open(count, DriveKind.OMNI);
  }

  /** Two passages that meet where the group has no room to turn; robots wait in the first one. */
  @Test
  @Timeout(300)
  void aGroupIsLedSidewaysThroughAnOffsetDoor() throws Exception {
    OccupancyGrid drawn =
        OccupancyGrid.parse(
            "####################",
            "#...........########",
            "#...........########",
            "#...........########",
            "########...........#",
            "########...........#",
            "########...........#",
            "####################");
    OccupancyGrid grid =
        new OccupancyGrid(drawn.width(), drawn.height(), SIZE, Vec2.ZERO, drawn.occupied());
    List<Place> parking = List.of(new Place("P1", cell(1, 5)), new Place("P2", cell(1, 6)));
    List<Place> stations = List.of(new Place("A", cell(5, 5)), new Place("B", cell(15, 2)));
    open(new FloorMap("passages", grid, stations, parking, List.of()), DriveKind.OMNI);
    untilDone(order(8));
  }

  private void open(int count, DriveKind kind) throws Exception {
    List<Place> parking = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      parking.add(new Place("P" + (i + 1), cell(4 + 4 * i, 2)));
    }
    List<Place> stations =
        List.of(
            new Place("A", cell(8, 8)), new Place("B", cell(30, 8)), new Place("C", cell(20, 4)));
    open(new FloorMap("hall", grid(), stations, parking, List.of()), kind);
  }

  private void open(FloorMap floor, DriveKind kind) throws Exception {
    LiveFloor live = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED, kind);
    opened = live;
    live.start();
  }

  private static OccupancyGrid grid() {
    OccupancyGrid drawn = OccupancyGrid.parse(HALL);
    return new OccupancyGrid(drawn.width(), drawn.height(), SIZE, Vec2.ZERO, drawn.occupied());
  }

  private static Vec2 cell(int column, int rowFromBelow) {
    return new Vec2((column + 0.5) * SIZE, (rowFromBelow + 0.5) * SIZE);
  }

  private static String[] hall(int columns, int rows) {
    String[] hall = new String[rows];
    for (int row = 0; row < rows; row++) {
      boolean isWall = row == 0 || row == rows - 1;
      hall[row] = isWall ? "#".repeat(columns) : "#" + ".".repeat(columns - 2) + "#";
    }
    return hall;
  }
}
