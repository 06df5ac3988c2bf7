package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.DoubleAccumulator;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFloor;

/**
 * A whole server with real daemons that have four agents, in a hall with a free zone in its middle,
 * which is as wide as the hall.
 */
@Tag("full")
@Timeout(200)
class FreeZoneFleetTest {
  private static final double SPEED = 200;
  private static final double SIZE = 0.3;
  private static final double ROBOT = 0.255 / 2;

  /** Seconds between two places of what walks. */
  private static final double STEP = 0.02;

  /** Metres a second; who is slower stands. */
  private static final double STANDING = 0.02;

  private static final String[] HALL = {
    "#############################",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#...........................#",
    "#############################",
  };

  private static final Area ZONE = new Area(new Vec2(2.7, 0.3), 3.3, 3);

  @TempDir private Path folder;

  @SuppressWarnings("NullAway.Init") // by open, first of all
  private LiveFloor live;

  private final DoubleAccumulator nearest =
      new DoubleAccumulator(Math::min, Double.POSITIVE_INFINITY);

  /** Whether the robot, by its own motion, came nearer to what it touched. */
  private final AtomicBoolean wasDrivenInto = new AtomicBoolean();

  /** Whether the zone was stored as a robot's own. */
  private final AtomicBoolean wasLent = new AtomicBoolean();

  /** Whether a robot said that it does not find its way through the zone. */
  private final AtomicBoolean wasStuck = new AtomicBoolean();

  private void open(String[] rows, Vec2... parking) throws Exception {
    OccupancyGrid drawn = OccupancyGrid.parse(rows);
    FloorDrawing drawing =
        new FloorDrawing(
                new OccupancyGrid(drawn.width(), drawn.height(), SIZE, Vec2.ZERO, drawn.occupied()),
                List.of(
                    new Place("A", cell(4, 5)),
                    new Place("B", cell(25, 5)),
                    new Place("C", cell(25, 8)),
                    new Place("D", cell(4, 8)),
                    new Place("Middle", cell(15, 5))),
                IntStream.range(0, parking.length)
                    .mapToObj(i -> new Place("P" + (i + 1), parking[i]))
                    .toList(),
                List.of(),
                List.of(),
                List.of(),
                List.of())
            .withFreeZones(List.of(ZONE));
    FloorMap floor = new FloorMap("hall", drawing, Margins.USUAL);
    live = LiveFloor.withFourAgents(folder, floor, SimulatedFloor.of(floor), SPEED);
    live.clock.add(_ -> wasLent.compareAndSet(false, live.isZoneLent()), Duration.ofSeconds(1));
    live.clock.add(_ -> wasStuck.compareAndSet(false, isStuck()), Duration.ofMillis(100));
    live.start();
  }

  private boolean isStuck() {
    return live.fleet.snapshots().latest().robots().stream()
        .flatMap(robot -> robot.telemetry().errors().stream())
        .map(Fault::code)
        .anyMatch("ZONE_STUCK"::equals);
  }

  /** Through the zone by their own sense, and not by a path that they were given for it. */
  private void assertFoundTheirWay() {
    assertTrue(wasLent.get(), "was never lent the zone");
    assertFalse(wasStuck.get(), "did not find its way");
  }

  @AfterEach
  void close() throws Exception {
    live.close();
  }

  @Test
  void aTaskThroughTheZonePassesWhatMovesInIt() throws Exception {
    open(HALL, cell(2, 2));
    // to and fro across the way, at 0.1 m/s
    walk(0.15, seconds -> new Vec2(4.4, 1.65 + 0.7 * Math.sin(0.14 * seconds)));
    long there = live.submit(2, "A", "B");
    awaitDone(there);
    long back = live.submit(2, "C", "D");
    awaitDone(back);
    assertFalse(wasDrivenInto.get(), "drove into it, by " + nearest);
    assertTrue(nearest.get() < 0.6, "never met it: " + nearest);
    assertFoundTheirWay();
  }

  @Test
  void aPointInTheZoneIsDrivenToAndLeft() throws Exception {
    open(HALL, cell(2, 2));
    long task = live.submit(2, "A", "Middle");
    FleetSnapshot done = awaitDone(task);
    assertFoundTheirWay();
    assertEquals(1, done.robots().size());
  }

  @Test
  void whatTheMapShowsInTheZoneIsGoneRound() throws Exception {
    String[] rows = HALL.clone();
    rows[5] = rows[5].substring(0, 14) + "##" + rows[5].substring(16);
    rows[6] = rows[6].substring(0, 14) + "##" + rows[6].substring(16);
    open(rows, cell(2, 2));
    awaitDone(live.submit(2, "A", "B"));
    assertFoundTheirWay();
  }

  /** {@link LiveFloor} judges that they never touch. */
  @Test
  void twoRobotsGetThroughOneAfterTheOther() throws Exception {
    open(HALL, cell(2, 2), cell(26, 2));
    long there = live.submit(2, "A", "B");
    long back = live.submit(2, "C", "D");
    awaitDone(there);
    awaitDone(back);
    assertFoundTheirWay();
  }

  @Test
  void whoDoesNotFindItsWayIsGivenAPath() throws Exception {
    open(HALL, cell(2, 2));
    // a wall of boxes but for a gap far beside the way, which no agent looks for and a path does
    for (double y = 0.45; y < 2.3; y += 0.3) {
      live.world.putObstacle("box " + y, new Vec2(4.4, y), 0.15);
    }
    long task = live.submit(2, "A", "B");
    awaitDone(task);
    assertTrue(wasLent.get(), "was never lent the zone");
    assertTrue(wasStuck.get(), "found its way");
  }

  private FleetSnapshot awaitDone(long task) throws Exception {
    return live.await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
  }

  private void walk(double radius, DoubleFunction<Vec2> place) {
    AtomicLong steps = new AtomicLong();
    AtomicReference<Vec2> last = new AtomicReference<>();
    live.clock.add(
        _ -> {
          Vec2 at = place.apply(steps.incrementAndGet() * STEP);
          live.world.putObstacle("person", at, radius);
          live.robots
              .truePose("r1")
              .ifPresent(
                  truth -> {
                    double gap = truth.position().distanceTo(at) - radius - ROBOT;
                    nearest.accumulate(gap);
                    Vec2 before = last.getAndSet(truth.position());
                    boolean isDriving =
                        before != null
                            && before.distanceTo(at) - truth.position().distanceTo(at)
                                > STANDING * STEP;
                    wasDrivenInto.compareAndSet(false, gap < 0 && isDriving);
                  });
        },
        Duration.ofMillis(20));
  }

  /** The middle of a cell, counted from below. */
  private static Vec2 cell(int column, int row) {
    return new Vec2((column + 0.5) * SIZE, (row + 0.5) * SIZE);
  }
}
