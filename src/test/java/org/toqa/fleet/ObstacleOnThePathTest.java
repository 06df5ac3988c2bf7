package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.DoubleAccumulator;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFloor;

/** A real daemon finds something on its path that nobody has told it of. */
@Tag("full")
@Timeout(200)
class ObstacleOnThePathTest {
  private static final double SPEED = 200;
  private static final double SIZE = 0.3;
  private static final double ROBOT = 0.255 / 2;

  /** Metres a second. */
  private static final double WALKING = 0.1;

  /** Two rooms of cells of 0.3 m, and one door between them. */
  private static final String[] ROOMS = {
    "#########################",
    "#...........#...........#",
    "#...........#...........#",
    "#...........#...........#",
    "#.......................#",
    "#...........#...........#",
    "#...........#...........#",
    "#...........#...........#",
    "#########################",
  };

  private static final String[] HALL =
      Arrays.stream(ROOMS).map(row -> row.replace("..#..", ".....")).toArray(String[]::new);

  @TempDir private Path folder;

  @SuppressWarnings("NullAway.Init") // by open, first of all
  private LiveFloor live;

  /** Metres between the robot's rim and an obstacle at their nearest, as it truly is. */
  private final DoubleAccumulator nearest =
      new DoubleAccumulator(Math::min, Double.POSITIVE_INFINITY);

  @AfterEach
  void close() throws Exception {
    live.close();
  }

  private void open(String[] rows, Vec2... parking) throws Exception {
    OccupancyGrid drawn = OccupancyGrid.parse(rows);
    FloorMap floor =
        new FloorMap(
            "hall",
            new OccupancyGrid(drawn.width(), drawn.height(), SIZE, Vec2.ZERO, drawn.occupied()),
            List.of(new Place("A", cell(4, 4)), new Place("B", cell(21, 4))),
            IntStream.range(0, parking.length)
                .mapToObj(i -> new Place("P" + (i + 1), parking[i]))
                .toList(),
            List.of());
    live = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED);
    live.start();
  }

  @Test
  void theRobotGoesRoundABoxThatItFindsOnItsPath() throws Exception {
    open(ROOMS, cell(2, 2));
    put(cell(8, 4), 0.15);

    long task = live.submit(2, "A", "B");

    live.await(view -> !obstacles(view).equals(CellRuns.NONE) && isStopped(view, "r1"));
    live.await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
    assertTrue(nearest.get() > 0.02, "came as near as " + nearest);
    live.world.removeObstacle("box");
    live.await(view -> obstacles(view).equals(CellRuns.NONE));
  }

  @ParameterizedTest
  @CsvSource({"0", "0.1", "-0.16"})
  void theRobotPassesSomethingSmallWithoutAStop(double aside) throws Exception {
    open(HALL, cell(2, 2));
    Vec2 thing = new Vec2(cell(12, 4).x(), cell(12, 4).y() + aside);
    put(thing, 0.05);
    AtomicBoolean hasStopped = new AtomicBoolean();
    AtomicBoolean hasPassed = new AtomicBoolean();

    long task = live.submit(2, "A", "B");

    live.await(
        view -> {
          hasStopped.compareAndSet(false, isStopped(view, "r1"));
          hasPassed.compareAndSet(false, nearest.get() < 0.15);
          return LiveFloor.isInState(view, task, TaskState.DONE);
        });
    assertTrue(nearest.get() >= 0.01, "came as near as " + nearest);
    assertTrue(hasPassed.get(), "came no nearer than " + nearest);
    assertFalse(hasStopped.get(), "it stopped");
  }

  @Test
  void theRobotWaitsWhereThereIsNoPathRoundAndGoesOnWhenThereIs() throws Exception {
    open(ROOMS, cell(2, 2));
    put(cell(12, 4), 0.1);

    long task = live.submit(2, "A", "B");

    live.await(
        view ->
            LiveFloor.isInState(view, task, TaskState.CARRYING)
                && String.valueOf(LiveFloor.task(view, task).waitingFor()).contains("an obstacle"));
    assertTrue(nearest.get() > 0.02, "came as near as " + nearest);
    live.world.removeObstacle("box");
    live.await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
  }

  @Test
  void theRobotKeepsBehindAPersonWhoWalksAheadOfIt() throws Exception {
    open(ROOMS, cell(2, 2));
    AtomicLong walked = new AtomicLong();
    AtomicReference<Optional<Vec2>> person = new AtomicReference<>(Optional.of(cell(10, 4)));
    Duration stride = Duration.ofMillis(100);
    live.clock.add(
        nanos -> {
          boolean isClose = nearest.get() < 0.4; // a person does not hurry before
          long strides = isClose ? walked.incrementAndGet() : 0;
          double x = cell(10, 4).x() + WALKING * strides * stride.toMillis() / 1000;
          Optional<Vec2> at =
              Optional.of(new Vec2(x, cell(10, 4).y())).filter(p -> x < cell(15, 4).x());
          person.set(at);
          at.ifPresentOrElse(
              p -> live.world.putObstacle("person", p, 0.12),
              () -> live.world.removeObstacle("person"));
        },
        stride);
    watch("r1", person::get, 0.12);
    long task = live.submit(2, "A", "B");
    live.await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
    assertTrue(nearest.get() > 0.02 && nearest.get() < 0.4, "came as near as " + nearest);
  }

  @Test
  void aGroupStopsBeforeAnObstacleAndGoesOnWhenItIsGone() throws Exception {
    open(HALL, cell(2, 2), cell(2, 6));
    Vec2 middle = cell(13, 4);
    live.world.putObstacle("box", middle, 0.9);
    watch("r1", () -> Optional.of(middle), 0.9);
    watch("r2", () -> Optional.of(middle), 0.9);

    long task = live.submit(8, "A", "B");

    FleetSnapshot view =
        live.await(
            v -> LiveFloor.isInState(v, task, TaskState.CARRYING) && isStopped(v, leader(v, task)));
    assertTrue(nearest.get() > 0.02, "came as near as " + nearest);
    live.world.removeObstacle("box");
    live.await(v -> LiveFloor.isInState(v, task, TaskState.DONE));
    assertEquals(2, LiveFloor.task(view, task).robots().size());
  }

  private static String leader(FleetSnapshot view, long task) {
    return LiveFloor.task(view, task).robots().getFirst();
  }

  /** Whether a robot reports an obstacle on its path. */
  private static boolean isStopped(FleetSnapshot view, String robot) {
    return view.robots().stream()
        .filter(r -> r.name().equals(robot))
        .flatMap(r -> r.telemetry().errors().stream())
        .anyMatch(fault -> fault.code().equals("OBSTACLE"));
  }

  /** Puts a round box, and watches how near the robot comes to it. */
  private void put(Vec2 middle, double radius) {
    live.world.putObstacle("box", middle, radius);
    watch("r1", () -> Optional.of(middle), radius);
  }

  private void watch(String robot, Supplier<Optional<Vec2>> middle, double radius) {
    live.clock.add(
        nanos ->
            live.robots
                .truePose(robot)
                .flatMap(truth -> middle.get().map(m -> truth.position().distanceTo(m)))
                .ifPresent(apart -> nearest.accumulate(apart - radius - ROBOT)),
        Duration.ofMillis(20));
  }

  private static CellRuns obstacles(FleetSnapshot view) {
    return view.floors().getFirst().obstacles();
  }

  /** The middle of a cell, counted from below. */
  private static Vec2 cell(int column, int row) {
    return new Vec2((column + 0.5) * SIZE, (row + 0.5) * SIZE);
  }
}
