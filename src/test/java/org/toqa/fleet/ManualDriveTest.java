package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.motion.DriveKind;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.VirtualClock;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A person drives a robot by hand over a floor where real daemons drive simulated bodies. Whatever
 * a test is about, {@link LiveFloor} judges where these truly are: none may touch another or a
 * wall.
 */
@Tag("full")
@Timeout(200)
class ManualDriveTest {
  /** Robots that are driven by hand report each step: faster, the link would pass reports over. */
  private static final double SPEED = 20;

  private static final double SIZE = 0.3;
  private static final Duration RENEWED_EVERY = Duration.ofMillis(100);

  /** Metres that a robot settles by where it stands. */
  private static final double STILL = 0.001;

  /** What is promised. */
  private static final Duration STANDS_WITHIN = Duration.ofMillis(500);

  private static final OccupancyGrid HALL =
      OccupancyGrid.parse(
          "############",
          "#..........#",
          "#..........#",
          "#..........#",
          "#..........#",
          "#..........#",
          "############");

  @TempDir private Path folder;
  private LiveFloor live;

  /** A person's hand on the buttons of one robot. */
  private final class Hand {
    final String robot;
    final String user;
    @Nullable UUID lease;
    long number;

    Hand(String robot, String user) {
      this.robot = robot;
      this.user = user;
    }

    Answer<ManualAnswer> order(double speed, double turnRate) throws Exception {
      var asked =
          live.fleet.driveByHand(robot, new ManualOrder(lease, ++number, speed, turnRate), user);
      live.pass(RENEWED_EVERY);
      Answer<ManualAnswer> answer = asked.toCompletableFuture().get(10, TimeUnit.SECONDS);
      if (answer instanceof Answer.Accepted<ManualAnswer>(ManualAnswer accepted)) {
        lease = accepted.lease();
      }
      return answer;
    }

    /** Keeps the button pressed; why the robot did not go on at last, if it did not. */
    Optional<Phrase> press(double speed, double turnRate, Duration time) throws Exception {
      Optional<Phrase> refusal = Optional.empty();
      for (Duration left = time; left.isPositive(); left = left.minus(RENEWED_EVERY)) {
        Answer<ManualAnswer> answer = order(speed, turnRate);
        if (!(answer instanceof Answer.Accepted<ManualAnswer>(ManualAnswer accepted))) {
          return fail(answer.toString());
        }
        refusal = Optional.ofNullable(accepted.refusal()).map(Sentence::phrase);
      }
      return refusal;
    }

    void end() throws Exception {
      var asked = live.fleet.endManualDrive(robot, Objects.requireNonNull(lease), user);
      live.pass(RENEWED_EVERY);
      asked.toCompletableFuture().get(10, TimeUnit.SECONDS);
    }
  }

  private void open(DriveKind kind) throws Exception {
    FloorMap floor =
        new FloorMap(
            "hall",
            new OccupancyGrid(HALL.width(), HALL.height(), SIZE, Vec2.ZERO, HALL.occupied()),
            List.of(new Place("west", cell(1, 5)), new Place("east", cell(10, 5))),
            List.of(new Place("P1", cell(2, 1)), new Place("P2", cell(6, 1))),
            List.of());
    live = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED, kind);
    live.start();
  }

  @BeforeEach
  void openOnTwoWheels() throws Exception {
    open(DriveKind.DIFFERENTIAL);
  }

  @AfterEach
  void judge() throws Exception {
    live.close();
  }

  @Test
  void aRobotStandsBeforeAWallAndSaysWhy() throws Exception {
    Hand ana = new Hand("r1", "Ana");
    Optional<Phrase> refusal = ana.press(-0.12, 0, Duration.ofSeconds(12));
    assertEquals(Optional.of(Phrase.WALL_IN_THE_WAY), refusal);
    double west = live.truePlace("r1").x() - SIZE - robot("r1").capabilities().footprint() / 2;
    assertTrue(west > 0.005 && west < 0.06, west + " m from the wall");
    assertNull(ana.press(0.12, 0, Duration.ofSeconds(2)).orElse(null), "it may drive away");
  }

  @Test
  void aRobotStandsBeforeAnotherAndSaysWhoThatIs() throws Exception {
    Hand ana = new Hand("r1", "Ana");
    Optional<Phrase> refusal = ana.press(0.12, 0, Duration.ofSeconds(15));
    assertEquals(Optional.of(Phrase.ROBOT_IN_THE_WAY), refusal);
    double gap =
        live.truePlace("r2").x()
            - live.truePlace("r1").x()
            - robot("r1").capabilities().footprint();
    assertTrue(gap > 0.05 && gap < 0.2, gap + " m apart");
  }

  @Test
  void aRobotThatIsDrivenIntoAnothersWayWaitsForItAndTheTaskIsDone() throws Exception {
    Hand ana = new Hand("r1", "Ana");
    assertEquals(Optional.empty(), ana.press(0, 0.6, Duration.ofMillis(2600))); // faces north
    long task = live.submit(2, "west", "east");
    boolean wasRefused = false;
    for (int i = 0; i < 400 && !LiveFloor.isInState(view(), task, TaskState.DONE); i++) {
      // to and fro over the way of the other
      Optional<Phrase> refusal = ana.press((i / 90) % 2 == 0 ? 0.12 : -0.12, 0, RENEWED_EVERY);
      wasRefused |= refusal.equals(Optional.of(Phrase.ROBOT_IN_THE_WAY));
    }
    ana.end();
    assertTrue(wasRefused, "they met");
    live.await(v -> LiveFloor.isInState(v, task, TaskState.DONE));
    assertEquals(List.of("r2"), LiveFloor.task(view(), task).robots());
  }

  private enum Loss {
    /** The button is released. */
    RELEASED,
    /** Nothing more comes: the page is closed, the network cut, the session over. */
    CUT,
    /** The server is killed. */
    KILLED,
    /** Somebody puts the robot on hold. */
    HELD
  }

  @ParameterizedTest
  @EnumSource(Loss.class)
  void theRobotStandsWithinHalfASecond(Loss loss) throws Exception {
    Hand ana = new Hand("r1", "Ana");
    ana.press(0, 0.6, Duration.ofMillis(2600)); // faces north, where there is room
    Vec2 start = live.truePlace("r1");
    ana.press(0.12, 0, Duration.ofSeconds(4));
    double driven = live.truePlace("r1").distanceTo(start);
    assertTrue(driven > 0.3, driven + " m in 4 s at 0.12 m/s");
    Vec2 before = live.truePlace("r1");
    ana.press(0.12, 0, RENEWED_EVERY);
    assertTrue(live.truePlace("r1").distanceTo(before) > 0.005, "it drives");

    long lost = live.clock.nanos();
    switch (loss) {
      case RELEASED -> {
        var _ = live.fleet.driveByHand("r1", new ManualOrder(ana.lease, ++ana.number, 0, 0), "Ana");
      }
      case HELD -> {
        var _ = live.fleet.holdRobot("r1", "Ben");
      }
      case KILLED -> live.fleet.close();
      case CUT -> lost -= RENEWED_EVERY.toNanos(); // when the last order was given
    }
    assertStandsBy(lost + STANDS_WITHIN.toNanos(), loss == Loss.KILLED);
  }

  private void assertStandsBy(long nanos, boolean isServerGone) throws Exception {
    while (live.clock.nanos() < nanos) {
      goOn(VirtualClock.STEP, isServerGone);
    }
    Vec2 there = live.truePlace("r1");
    for (int step = 0; step < 150; step++) {
      goOn(VirtualClock.STEP, isServerGone);
    }
    double moved = live.truePlace("r1").distanceTo(there);
    assertTrue(moved < STILL, "It still moved by " + moved + " m.");
  }

  private void goOn(Duration time, boolean isServerGone) throws Exception {
    if (isServerGone) {
      live.stepWithoutServer();
    } else {
      live.pass(time);
    }
  }

  @Test
  void onePersonAtATimeDrivesARobotAndItIsGivenNoTask() throws Exception {
    Hand ana = new Hand("r1", "Ana");
    ana.press(0.12, 0, Duration.ofSeconds(1));
    Hand ben = new Hand("r1", "Ben");
    assertConflict(Phrase.DRIVEN_BY_ANOTHER, ben.order(0.12, 0));
    assertEquals("Ana", robot("r1").work().driver());
    assertEquals(Phrase.DRIVEN_BY_HAND, robot("r1").work().doing().phrase());

    ana.end();
    ben.press(0.12, 0, Duration.ofSeconds(1));
    assertEquals("Ben", robot("r1").work().driver());
    assertConflict(Phrase.DRIVEN_BY_ANOTHER, ana.order(0.12, 0));

    live.pass(Duration.ofSeconds(11)); // Ben has gone
    assertNull(robot("r1").work().driver());
    assertConflict(Phrase.MANUAL_DRIVE_IS_OVER, ben.order(0.12, 0));
  }

  @Test
  void aRobotWithATaskOrOnHoldIsNotDrivenByHand() throws Exception {
    long task = live.submit(2, "west", "east");
    FleetSnapshot begun = live.await(v -> LiveFloor.isInState(v, task, TaskState.TO_OBJECT));
    String busy = LiveFloor.task(begun, task).robots().getFirst();
    assertConflict(Phrase.MANUAL_DRIVE_AFTER_TASK, new Hand(busy, "Ana").order(0.12, 0));

    String idle = busy.equals("r1") ? "r2" : "r1";
    Hand ana = new Hand(idle, "Ana");
    ana.press(0, 0.6, Duration.ofSeconds(1));
    var held = live.fleet.holdRobot(idle, "Ben");
    live.pass(RENEWED_EVERY);
    held.toCompletableFuture().get(10, TimeUnit.SECONDS);
    assertConflict(Phrase.LET_IT_GO_ON_FIRST, ana.order(0, 0.6));
    live.pass(Duration.ofMillis(200));
    assertNull(robot(idle).work().driver());
  }

  @Test
  void anOrderThatComesTooLateChangesNothing() throws Exception {
    Hand ana = new Hand("r1", "Ana");
    ana.press(0.12, 0, Duration.ofSeconds(1));
    ana.order(0, 0);
    live.pass(Duration.ofSeconds(1));
    Vec2 there = live.truePlace("r1");
    ana.number -= 5;
    ana.order(0.12, 0);
    live.pass(Duration.ofSeconds(1));
    assertTrue(live.truePlace("r1").distanceTo(there) < STILL);
  }

  private static void assertConflict(Phrase expected, Answer<ManualAnswer> answer) {
    assertTrue(
        answer instanceof Answer.Conflict<ManualAnswer>(var sentence, var _)
            && sentence.phrase() == expected,
        answer::toString);
  }

  private RobotView robot(String name) {
    return view().robots().stream().filter(r -> r.name().equals(name)).findFirst().orElseThrow();
  }

  private FleetSnapshot view() {
    return live.fleet.snapshots().latest();
  }

  /** The middle of a cell, counted from below. */
  private static Vec2 cell(int column, int row) {
    return new Vec2((column + 0.5) * SIZE, (row + 0.5) * SIZE);
  }
}
