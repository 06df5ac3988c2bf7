package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.mission.TaskState;
import org.toqa.persistence.StoreException;
import org.toqa.sim.SimulatedFloor;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** A map comes in force while robots drive. */
class PublishedMapTest {
  private static final double SPEED = 50;
  private static final int COLUMNS = 40;
  private static final int ROWS = 14;
  private static final double CELL = 0.3;

  /** Between the stations; its ends stay open. */
  private static final int WALL_COLUMN = 26;

  @TempDir private Path folder;
  private LiveFloor live;

  @BeforeEach
  void open() throws Exception {
    FloorMap floor =
        new FloorMap(
            "hall",
            new OccupancyGrid(COLUMNS, ROWS, CELL, Vec2.ZERO, new BitSet()),
            List.of(new Place("West", new Vec2(3, 2.1)), new Place("East", new Vec2(10.5, 2.1))),
            List.of(new Place("P1", new Vec2(0.9, 0.9)), new Place("P2", new Vec2(0.9, 3.3))),
            List.of());
    live = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED);
    live.start();
  }

  @AfterEach
  void close() throws Exception {
    live.close();
  }

  @Test
  void robotOnItsWayGoesRoundANewWall() throws Exception {
    long task = live.submit(2, "West", "East");
    live.await(view -> LiveFloor.isInState(view, task, TaskState.CARRYING));
    FloorMap before = live.fleet.floors().getFirst();
    FloorDrawing next = withWall(before.drawing());

    FloorEditing editing = live.fleet.floorEditing();
    List<MapProblem> problems =
        accepted(editing.check("hall", next, "Max")).stream()
            .filter(MapProblem::isBlocking)
            .toList();
    assertEquals(List.of(), problems);
    long revision = editing.draft("hall").orElseThrow().revision();
    long saved = accepted(editing.saveDraft("hall", next, revision, "Max")).revision();
    assertTrue(
        editing.publish("hall", revision, "Max").toCompletableFuture().get(10, TimeUnit.SECONDS)
            instanceof Answer.Outdated<FloorMap>);
    assertEquals(next, accepted(editing.publish("hall", saved, "Max")).drawing());
    assertEquals(next, live.fleet.floors().getFirst().drawing());
    assertFalse(editing.draft("hall").orElseThrow().isDraft());

    List<Vec2> track = new ArrayList<>();
    live.clock.add(nanos -> look(track), Duration.ofMillis(100));
    live.await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
    Disc body = new Disc(0.1275);
    for (Vec2 point : track) {
      assertTrue(body.isFreeAt(next.walls(), point), () -> "in the new wall at " + point);
    }
    assertTrue(track.stream().anyMatch(point -> point.x() > 9), "it came to the other side");
  }

  @Test
  void stationsOfAnotherFloorAreNotDrawnTwice() throws Exception {
    FloorEditing editing = live.fleet.floorEditing();
    FloorDrawing hall = live.fleet.floors().getFirst().drawing();
    String taken =
        "The floor hall has a station West already, and names of stations are unique in a site."
            + " Choose another name.";

    assertEquals(taken, refused(editing.addFloor("cellar", hall, "Max")));
    assertEquals(1, live.fleet.floors().size());

    accepted(editing.addFloor("cellar", FloorDrawing.of(hall.walls()), "Max"));
    long revision = editing.draft("cellar").orElseThrow().revision();
    long saved = accepted(editing.saveDraft("cellar", hall, revision, "Max")).revision();
    assertTrue(
        refused(editing.publish("cellar", saved, "Max")).contains(taken),
        "it is not published either");
  }

  @Test
  void whatSpeaksAgainstAMapForWhoeverListensKeepsItFromBeingPublished() throws Exception {
    FloorEditing editing = live.fleet.floorEditing();
    FloorDrawing next = withWall(live.fleet.floors().getFirst().drawing());
    MapProblem problem = new MapProblem(true, Sentence.verbatim("It is in use."), null);
    live.fleet.addFloorListener(
        new FloorListener.Objector() {
          @Override
          public Optional<Sentence> objectionToRemoval(String floor) {
            return Optional.empty();
          }

          @Override
          public List<MapProblem> mapProblems(String floor, FloorDrawing drawing) {
            return floor.equals("hall") && drawing.equals(next) ? List.of(problem) : List.of();
          }
        });

    assertTrue(accepted(editing.check("hall", next, "Max")).contains(problem));
    long revision = editing.draft("hall").orElseThrow().revision();
    long saved = accepted(editing.saveDraft("hall", next, revision, "Max")).revision();
    assertTrue(refused(editing.publish("hall", saved, "Max")).endsWith("It is in use."));
  }

  @Test
  void robotForAFloorThatIsBeingRemovedIsToldThatThereIsNone() throws Exception {
    RobotOrder order = new RobotOrder("r9", "127.0.0.1", 1, 5, null, null, null, "cellar", null);
    assertNoCellar(() -> live.fleet.addRobot(order, "Max"));
  }

  @Test
  void robotForAFloorThatIsBeingRemovedStaysWhereItIs() throws Exception {
    accepted(live.fleet.takeOutOfService("r2", "Max"));
    RobotMove move = new RobotMove("cellar", new Pose(3, 2.1, 0));
    assertNoCellar(() -> live.fleet.moveRobot("r2", move, "Max"));
    assertEquals(
        List.of("hall", "hall"), live.store.robots().stream().map(RobotRecord::floor).toList());
    assertEquals("hall", accepted(live.fleet.putInService("r2", "Max")).floor());
  }

  /** The database went away in a commit that it had done. */
  @Test
  void aFloorIsThereOrGoneAsIsStoredThoughTheCommitWasNotAnswered() throws Exception {
    FloorEditing editing = live.fleet.floorEditing();
    FloorDrawing cellar = FloorDrawing.of(live.fleet.floors().getFirst().drawing().walls());
    loseNextAnswer();
    assertThrows(
        ExecutionException.class,
        () ->
            editing
                .addFloor("cellar", cellar, "Max")
                .toCompletableFuture()
                .get(10, TimeUnit.SECONDS));
    awaitFloors(List.of("hall", "cellar"));
    assertTrue(editing.draft("cellar").isPresent());

    loseNextAnswer();
    assertThrows(
        ExecutionException.class,
        () -> editing.removeFloor("cellar", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS));
    awaitFloors(List.of("hall"));
    accepted(editing.addFloor("cellar", cellar, "Max"));
  }

  private void loseNextAnswer() {
    live.floors.setAfterChange(
        () -> {
          live.floors.setAfterChange(() -> {});
          throw new StoreException("The connection broke.", null);
        });
  }

  private void awaitFloors(List<String> names) throws InterruptedException {
    live.await(_ -> live.fleet.floors().stream().map(FloorMap::name).toList().equals(names));
  }

  /** What is asked while a floor is being removed is answered as if it were gone. */
  private void assertNoCellar(Supplier<CompletionStage<Answer<RobotView>>> question)
      throws Exception {
    FloorEditing editing = live.fleet.floorEditing();
    FloorDrawing hall = live.fleet.floors().getFirst().drawing();
    accepted(editing.addFloor("cellar", FloorDrawing.of(hall.walls()), "Max"));
    List<CompletionStage<Answer<RobotView>>> answers = new ArrayList<>();
    live.floors.setWhileRemoving(() -> answers.add(question.get()));

    accepted(editing.removeFloor("cellar", "Max"));

    assertEquals(
        new Answer.Rejected<>(
            "floor", Phrase.NO_SUCH_FLOOR_BUT.with("cellar", Sentence.names(List.of("hall")))),
        answers.getFirst().toCompletableFuture().get(10, TimeUnit.SECONDS));
  }

  private static <T> String refused(CompletionStage<Answer<T>> answer) throws Exception {
    Answer<T> given = answer.toCompletableFuture().get(10, TimeUnit.SECONDS);
    return ((Answer.Conflict<T>) given).sentence().english();
  }

  private void look(List<Vec2> track) {
    for (String robot : List.of("r1", "r2")) {
      live.robots.truePose(robot).map(Pose::position).ifPresent(track::add);
    }
  }

  private static FloorDrawing withWall(FloorDrawing drawing) {
    BitSet walls = drawing.walls().occupied();
    for (int row = 3; row < ROWS - 3; row++) {
      walls.set(row * COLUMNS + WALL_COLUMN);
    }
    return drawing.withWalls(drawing.walls().withOccupied(walls));
  }

  private static <T> T accepted(CompletionStage<Answer<T>> answer) throws Exception {
    Answer<T> given = answer.toCompletableFuture().get(10, TimeUnit.SECONDS);
    assertTrue(given instanceof Answer.Accepted<T>, given::toString);
    return ((Answer.Accepted<T>) given).value();
  }
}
