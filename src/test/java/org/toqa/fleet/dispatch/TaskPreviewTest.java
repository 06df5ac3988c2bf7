package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetStage;
import org.toqa.fleet.PathAnswer;
import org.toqa.fleet.PathQuestion;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.mission.TransportTask.LoadSize;

/** What is told of a task before it is asked for, against what then becomes of it. */
@Timeout(60)
class TaskPreviewTest {
  /** Kilograms; each robot carries 5. */
  private static final double LIGHT = 2;

  private FloorMap floor;
  private FleetStage stage;

  @BeforeEach
  void start() throws Exception {
    floor = FloorReader.read(Path.of("maps", "lab.yaml"));
    stage = new FleetStage(floor);
    stage.add("r1", at("P1"), "P1");
    stage.add("r2", at("P2"), "P2");
    stage.restart();
    stage.await(
        view ->
            view.robots().size() == 2
                && view.robots().stream()
                    .allMatch(
                        r -> r.state() == RobotState.IDLE && r.telemetry().battery() != null));
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void theRobotThatIsNamedIsTheOneThatGetsIt() throws Exception {
    TaskPreview told = preview(order(LIGHT));

    assertEquals(1, told.robots());
    assertEquals(List.of("r1"), told.chosen());
    assertEquals(List.of(), stage.fleet.snapshots().latest().tasks(), "nothing is stored");
    stage.fleet.submit(order(LIGHT), "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    stage.await(
        view -> !view.tasks().isEmpty() && view.tasks().getFirst().robots().equals(told.chosen()));
  }

  @Test
  void thePathIsFreeFromEndToEnd() throws Exception {
    TaskPreview told = preview(order(LIGHT));

    assertEquals(at("Mill"), told.path().getFirst());
    assertEquals(at("Goods-out"), told.path().getLast());
    Disc robot = new Disc(PlaceCheck.SMALLEST_RADIUS);
    for (int i = 1; i < told.path().size(); i++) {
      Vec2 from = told.path().get(i - 1);
      Vec2 step = told.path().get(i).minus(from);
      for (int k = 0; k <= 100; k++) {
        assertTrue(robot.isFreeAt(floor.grid(), from.plus(step.times(k / 100.0))), told::toString);
      }
    }
    assertTrue(told.metres() > at("Mill").distanceTo(at("Goods-out")), told::toString);
  }

  @Test
  void thePathBetweenTwoPlacesIsTheSameWithoutATask() throws Exception {
    PathAnswer path = accepted(path("Mill", "Goods-out"));

    assertEquals(preview(order(LIGHT)).path(), path.points());
    assertEquals(
        path.metres(), accepted(path("Goods-out", "Mill")).metres(), 0.05, "it is as far back");
    assertEquals(0, accepted(path("Mill", "Mill")).metres());
    assertInstanceOf(Answer.Rejected.class, path("Mill", "Nowhere"));
    assertInstanceOf(Answer.Rejected.class, path("Nowhere", "Mill"));
  }

  private Answer<PathAnswer> path(String start, String goal) throws Exception {
    return stage
        .fleet
        .path(new PathQuestion(null, new Where.Station(start), new Where.Station(goal)), "Clara")
        .toCompletableFuture()
        .get(10, TimeUnit.SECONDS);
  }

  private static PathAnswer accepted(Answer<PathAnswer> answer) {
    assertInstanceOf(Answer.Accepted.class, answer, answer::toString);
    return ((Answer.Accepted<PathAnswer>) answer).value();
  }

  @Test
  void aHeavyLoadNeedsBoth() throws Exception {
    TaskPreview told = preview(order(8, "Packing 1", "Mill"));

    assertEquals(2, told.robots());
    assertEquals(List.of("r1", "r2"), told.chosen(), told.reason()::english);
  }

  @Test
  void whatNoTeamHasRoomForIsRefusedAndToldWhere() throws Exception {
    assertRefused("around the load at Mill", order(8, "Mill", "Goods-out", new LoadSize(3, 3)));
    assertRefused("is 0.90 m wide", order(8, "Packing 2", "Workbench 2", new LoadSize(0.7, 0.7)));
  }

  private void assertRefused(String why, TaskOrder order) throws Exception {
    for (Answer<?> answer :
        List.of(
            stage.fleet.preview(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS),
            stage.fleet.submit(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS))) {
      Answer.Rejected<?> refused = assertInstanceOf(Answer.Rejected.class, answer);
      assertEquals("load", refused.field());
      assertTrue(refused.sentence().english().contains(why), refused.sentence()::english);
    }
  }

  /** Only who is there counts, not who can come just now. */
  @Test
  void whatATeamHasRoomForIsAcceptedThoughItWaits() throws Exception {
    occupyBoth();

    assertEquals(List.of(), preview(order(8, "Packing 1", "Mill")).chosen());
    assertInstanceOf(
        Answer.Accepted.class,
        stage
            .fleet
            .submit(order(8, "Packing 1", "Mill"), "Clara")
            .toCompletableFuture()
            .get(10, TimeUnit.SECONDS));
  }

  @Test
  void whatAllAreBusyForWaitsAndSaysForWhat() throws Exception {
    occupyBoth();

    TaskPreview told = preview(order(LIGHT));

    assertEquals(1, told.robots());
    assertEquals(List.of(), told.chosen());
    assertTrue(told.reason().english().contains("is working on task 1"), told.reason()::english);
  }

  private void occupyBoth() throws Exception {
    for (int i = 0; i < 2; i++) {
      stage.fleet.submit(order(LIGHT), "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    }
    stage.await(view -> view.robots().stream().allMatch(r -> r.work().task() != null));
  }

  @Test
  void whatWouldBeRefusedIsRefused() throws Exception {
    Answer<TaskPreview> answer =
        stage.fleet.preview(order(10.5), "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);

    Answer.Rejected<?> refused = assertInstanceOf(Answer.Rejected.class, answer);
    assertEquals("load", refused.field());
  }

  private Vec2 at(String place) {
    return floor.place(place).orElseThrow().position();
  }

  private TaskPreview preview(TaskOrder order) throws Exception {
    Answer<TaskPreview> answer =
        stage.fleet.preview(order, "Clara").toCompletableFuture().get(10, TimeUnit.SECONDS);
    return switch (answer) {
      case Answer.Accepted<TaskPreview>(TaskPreview told) -> told;
      default -> throw new AssertionError(answer);
    };
  }

  private static TaskOrder order(double load) {
    return order(load, "Mill", "Goods-out");
  }

  private static TaskOrder order(double load, String start, String goal) {
    return order(load, start, goal, null);
  }

  private static TaskOrder order(double load, String start, String goal, @Nullable LoadSize size) {
    return new TaskOrder(
        "crate", load, new Where.Station(start), new Where.Station(goal), null, 0, null, size);
  }
}
