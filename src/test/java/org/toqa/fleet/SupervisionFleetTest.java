package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.supervision.SupervisedBox;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedBoxes;
import org.toqa.sim.SimulatedBoxes.Placed;
import org.toqa.sim.SimulatedFloor;
import org.toqa.sim.SimulatedStore;
import org.toqa.store.JdbiSupervisionStore;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** A supervisor and two workers, real daemons over simulated bodies in a world with boxes. */
@Tag("full")
@Timeout(200)
class SupervisionFleetTest {
  private static final double SPEED = 40;
  private static final double SIZE = 0.5;

  /** Two rooms; nobody sees from one what lies in the other. */
  private static final OccupancyGrid ROOMS =
      OccupancyGrid.parse(
          "...............",
          "...............",
          "...............",
          ".......#.......",
          ".......#.......",
          ".......#.......",
          ".......#.......",
          ".......#.......",
          ".......#.......",
          ".......#.......");

  private static final Map<Integer, Vec2> TARGETS =
      Map.of(1, new Vec2(1, 4.25), 2, new Vec2(2.25, 3.25));

  private static final Vec2 LIGHT = new Vec2(6.75, 1.25);
  private static final Vec2 HEAVY = new Vec2(5.75, 2.25);

  @TempDir private Path folder;
  private LiveFloor live;
  private SimulatedBoxes boxes;
  private Supervisor supervisor;

  @BeforeEach
  void open() throws Exception {
    FloorMap floor =
        new FloorMap(
            "rooms",
            new OccupancyGrid(ROOMS.width(), ROOMS.height(), SIZE, Vec2.ZERO, ROOMS.occupied()),
            List.of(),
            List.of(
                new Place("P1", new Vec2(0.75, 0.75)),
                new Place("P2", new Vec2(1.75, 0.75)),
                new Place("P3", new Vec2(2.75, 0.75))),
            List.of());
    boxes = SimulatedBoxes.of(List.of(new Placed(1, LIGHT, 1.5), new Placed(2, HEAVY, 8)));
    SimulatedFloor world = SimulatedFloor.of(floor);
    world.putBoxes(boxes);
    SimulatedStore equipment =
        new SimulatedStore("rooms", Set.of("r1", "r2"), Set.of("r3"), 4, List.of());
    live = new LiveFloor(folder, floor, world, SPEED, equipment::equipped);
    supervisor = newSupervisor();
    live.start();
    awaitCamera(true);
  }

  /** As a server that begins: it knows what is stored. */
  private Supervisor newSupervisor() {
    return new Supervisor(
        new JdbiSupervisionStore(live.jdbi),
        live.fleet,
        live.store,
        live.clock,
        InstantSource.system());
  }

  @AfterEach
  void close() throws Exception {
    supervisor.close();
    live.close();
  }

  private Answer<Supervision> start(String worker) throws Exception {
    return start(worker, TARGETS);
  }

  private Answer<Supervision> start(String worker, Map<Integer, Vec2> targets) throws Exception {
    return supervisor
        .start(new SupervisionOrder("rooms", "r3", List.of("r1", worker), true, targets), "Clara")
        .toCompletableFuture()
        .get(10, TimeUnit.SECONDS);
  }

  private void awaitCamera(boolean isSeeing) throws InterruptedException {
    live.await(
        view ->
            view.robots().stream()
                .anyMatch(
                    robot ->
                        robot.name().equals("r3")
                            && (robot.telemetry().readings().camera() != null) == isSeeing));
  }

  /** Lets the world go on, and the supervisor look, until it is so. */
  private Supervision await(Predicate<Supervision> condition) throws InterruptedException {
    while (!condition.test(now())) {
      live.pass(Duration.ofMillis(500));
      supervisor.look();
    }
    return now();
  }

  private Supervision now() {
    return supervisor.latest("rooms").orElseThrow();
  }

  private SupervisedBox box(int number) {
    return Objects.requireNonNull(now().boxes().get(number));
  }

  private List<TaskView> tasksOf(int number) {
    return live.store.tasks(0, 100).stream()
        .filter(task -> task.task().name().equals("Box " + number))
        .toList();
  }

  /** It is delivered when its leader says so; the last one lets go of it a moment later. */
  private void assertAtTarget(int number) throws InterruptedException {
    live.await(_ -> boxes.placeOf(number).isPresent());
    Optional<Vec2> place = boxes.placeOf(number);
    assertTrue(
        place
            .filter(p -> p.distanceTo(Objects.requireNonNull(TARGETS.get(number))) < 0.3)
            .isPresent(),
        place::toString);
  }

  @Test
  void boxesAreFoundWeighedAndCarriedAndOneThatIsTooHeavyByTwo() throws Exception {
    refusesWhoCannotDoIt();
    asksAPersonWhileItSeesNothing();
    assertNull(box(1).place(), "it has not seen the other room");
    await(s -> box(2).weight() != null);
    assertEquals(8, Objects.requireNonNull(box(2).weight()), 0.01);

    supervisor.close();
    supervisor = newSupervisor(); // the server was killed
    supervisor.recover();
    Supervision done = await(s -> !s.isRunning());

    assertEquals(Supervision.State.DONE, done.state());
    assertAtTarget(1);
    assertAtTarget(2);
    assertEquals(1, tasksOf(1).size(), "it was carried once");
    assertEquals(1.5, Objects.requireNonNull(box(1).weight()), 0.01);
    List<TaskView> heavy = tasksOf(2); // the newest first
    assertEquals(2, heavy.size());
    assertEquals(8, heavy.getFirst().task().load(), 0.01);
    assertEquals(Set.of("r1", "r2"), Set.copyOf(heavy.getFirst().robots()));
    assertEquals(TaskState.CANCELLED, heavy.getLast().state());
    assertTrue(done.idleSecondsPerBox().orElseThrow() > 0);
    asksAPersonWhereABoxIs();
    cancelsWhatNobodyHasWhenItIsStopped();
  }

  @Test
  void aSupervisorThatWasCarriedToAnotherFloorIsMissed() throws Exception {
    assertInstanceOf(Answer.Accepted.class, start("r2"));
    FloorDrawing attic = FloorDrawing.of(OccupancyGrid.parse("...", "...", "..."));
    accepted(live.fleet.floorEditing().addFloor("attic", attic, "Max"));
    accepted(live.fleet.takeOutOfService("r3", "Max"));
    Pose there = new Pose(1.5, 1.5, 0);
    await(
        _ -> {
          answer(live.fleet.moveRobot("r3", new RobotMove("attic", there), "Max"));
          return live.fleet.snapshots("attic").orElseThrow().latest().robots().size() == 1;
        });
    supervisor.look();

    assertEquals(
        Optional.of(Phrase.SUPERVISION_NO_ROBOT.with("r3", "rooms")), supervisor.warning("rooms"));
  }

  private static <T> void accepted(CompletionStage<Answer<T>> asked) {
    assertInstanceOf(Answer.Accepted.class, answer(asked));
  }

  private static <T> Answer<T> answer(CompletionStage<Answer<T>> asked) {
    return asked.toCompletableFuture().orTimeout(10, TimeUnit.SECONDS).join();
  }

  private void refusesWhoCannotDoIt() throws Exception {
    assertInstanceOf(Answer.Rejected.class, start("r3"), "the supervisor is no worker");
    live.world.setCameraBlind("r3", true);
    awaitCamera(false);
    assertInstanceOf(Answer.Rejected.class, start("r2"), "it sees nothing");
    live.world.setCameraBlind("r3", false);
    awaitCamera(true);
    assertInstanceOf(Answer.Accepted.class, start("r2"));
    assertInstanceOf(Answer.Conflict.class, start("r2"), "one at a time");
  }

  private void asksAPersonWhileItSeesNothing() throws InterruptedException {
    live.world.setCameraBlind("r3", true);
    awaitCamera(false);
    supervisor.look();
    assertTrue(
        supervisor.warning("rooms").orElseThrow().english().contains("its camera sees nothing"));
    live.world.setCameraBlind("r3", false);
    awaitCamera(true);
    supervisor.look();
    assertTrue(supervisor.warning("rooms").isEmpty());
  }

  /** Box 9 is nowhere: it is looked for again, and left out when somebody says so. */
  private void asksAPersonWhereABoxIs() throws Exception {
    Map<Integer, Vec2> targets = Map.of(1, new Vec2(1.25, 2.25), 9, new Vec2(2.75, 4.25));
    assertInstanceOf(Answer.Accepted.class, start("r2", targets));
    await(_ -> said(supervisor.warning("rooms")).startsWith("Box 9 was found nowhere"));
    assertTrue(supervisor.report("rooms").orElseThrow().hasSeenAll());

    assertInstanceOf(
        Answer.Accepted.class, supervisor.lookAgain("rooms", "Max").toCompletableFuture().get());
    assertTrue(supervisor.report("rooms").isEmpty(), "what was seen counts no more");
    await(_ -> said(supervisor.warning("rooms")).startsWith("Box 9 was found nowhere"));
    await(_ -> box(1).delivered());
    assertEquals(
        List.of(new BoxView(1, new Vec2(1.25, 2.25), true)),
        live.fleet.snapshots().latest().floors().getFirst().boxes());
    assertInstanceOf(
        Answer.Conflict.class, supervisor.leaveOut("rooms", 1, "Max").toCompletableFuture().get());
    assertInstanceOf(
        Answer.Unknown.class, supervisor.leaveOut("rooms", 7, "Max").toCompletableFuture().get());
    assertInstanceOf(
        Answer.Accepted.class, supervisor.leaveOut("rooms", 9, "Max").toCompletableFuture().get());
    assertEquals(Supervision.State.DONE, await(s -> !s.isRunning()).state());
  }

  private static String said(Optional<Sentence> sentence) {
    return sentence.map(Sentence::english).orElse("");
  }

  /** The box is carried elsewhere; it is in view from where the supervisor waits. */
  private void cancelsWhatNobodyHasWhenItIsStopped() throws Exception {
    assertInstanceOf(
        Answer.Accepted.class,
        start("r2", Map.of(2, new Vec2(1.25, 2.25))),
        "the last one is done");
    await(s -> box(2).task() != null);
    Answer<Supervision> stopped =
        supervisor.stop("rooms", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS);
    assertInstanceOf(Answer.Accepted.class, stopped);
    assertEquals(Supervision.State.STOPPED, now().state());
    assertTrue(
        tasksOf(2).stream().noneMatch(task -> task.state() == TaskState.QUEUED), "none waits on");
  }

  @Test
  void aMapThatCutsOffATargetIsNotPublished() throws Exception {
    assertInstanceOf(Answer.Accepted.class, start("r2"));
    FloorDrawing drawing = live.fleet.floors().getFirst().drawing();
    assertEquals(List.of(), supervisor.mapProblems("rooms", drawing));

    OccupancyGrid before = drawing.walls();
    BitSet walls = before.occupied();
    int row = before.cellAt(new Vec2(1, 1.75)).row();
    for (int column = 0; column < before.width(); column++) {
      walls.set(row * before.width() + column);
    }
    FloorDrawing cut = drawing.withWalls(before.withOccupied(walls));
    List<MapProblem> problems = supervisor.mapProblems("rooms", cut);

    assertEquals(
        List.of("" + new Vec2(1, 4.25), "" + new Vec2(2.25, 3.25)),
        problems.stream().map(problem -> "" + problem.where()).toList());
    assertTrue(problems.stream().allMatch(MapProblem::isBlocking));
    assertTrue(
        problems.getFirst().text().english().startsWith("The supervision of rooms brings box 1 to"),
        () -> problems.getFirst().text().english());

    supervisor.stop("rooms", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS);
    assertEquals(List.of(), supervisor.mapProblems("rooms", cut));
  }
}
