package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.floor.ObstacleMap;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.message.ServerMessage;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.mission.Reply;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.wording.Phrase;

/** The agents over a real store, with robots that the test plays. */
@Timeout(60)
class FleetTest {
  /** Two rooms and one door between them, in cells of 1 m; (0, 0) is the lower left corner. */
  private static final OccupancyGrid GRID =
      OccupancyGrid.parse(
          "....#..........", //
          "...............",
          "....#..........");

  private static final Vec2 WEST = new Vec2(0.5, 0.5);
  private static final Vec2 DOOR = new Vec2(4.5, 1.5);
  private static final Vec2 EAST = new Vec2(8.5, 0.5);

  /** A few metres from r1, and more from the other end of the hall. */
  private static final Where IN_THE_MIDDLE = new Where.Point(new Vec2(6.5, 2.5));

  private static final FloorMap FLOOR =
      new FloorMap(
          "hall",
          GRID,
          List.of(new Place("West", new Vec2(0.5, 2.5)), new Place("East", new Vec2(8.5, 2.5))),
          List.of(new Place("P1", WEST), new Place("P2", EAST)),
          List.of());

  private final FleetStage stage = new FleetStage(FLOOR);

  @BeforeEach
  void start() {
    stage.add("r1", WEST, "P1");
    stage.restart();
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void anObstacleIsShownWhileItIsSeenAndAWhileLonger() throws Exception {
    scriptedRobot("r1").setObstacles(new Vec2(6.2, 1.1), new Vec2(6.8, 1.9), new Vec2(4.5, 0.5));

    until(view -> obstacles(view).equals(cells(new Cell(6, 1))));
    scriptedRobot("r1").setObstacles();
    Instant unseen = stage.now;
    until(view -> obstacles(view).equals(CellRuns.NONE));

    assertTrue(
        !stage.now.isBefore(unseen.plus(ObstacleMap.REMEMBER_FOR).minusMillis(200)),
        stage.now.toString());
    untilHistory(
        "floor.obstacle-gone",
        "The obstacle at (6.50, 1.50) was not seen any more; robots may drive there again");
    untilHistory(
        "floor.obstacle",
        "r1 sees something at (6.50, 1.50) that the map does not show; robots go round it");
  }

  @Test
  void whatARobotSeesWhereAnotherOneStandsIsNoObstacle() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> robot(view, "r2").state() == RobotState.IDLE);

    scriptedRobot("r1").setObstacles(EAST, new Vec2(6.5, 1.5));

    until(view -> !obstacles(view).equals(CellRuns.NONE));
    assertEquals(cells(new Cell(6, 1)), obstacles(stage.fleet.snapshots().latest()));
  }

  @Test
  void aLostRobotKeepsItsCellsUntilAPersonSaysThatItIsGone() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r2").fallSilent();
    until(view -> robot(view, "r2").state() == RobotState.LOST);
    assertEquals(
        Map.of("r2", cells(new Cell(4, 1))),
        stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells());
    long task = submit("West", "East");
    until(view -> waitReason(view, task).startsWith("Waits for r2"));

    RobotView taken = accepted(stage.fleet.takeOutOfService("r2", "Max"));

    assertEquals(RobotState.OUT_OF_SERVICE, taken.state());
    assertNull(taken.pose());
    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(Map.of(), stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells());
    assertEquals(
        List.of("Max took r2 out of service; it does not stand any more where it was lost"),
        history("robot.out-of-service"));
  }

  @Test
  void aRobotThatIsHeardAgainAfterItWasSaidToBeGoneHasItsPlaceAgain() throws Exception {
    reopenWith("r2", DOOR, null);
    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    scriptedRobot("r2").fallSilent();
    until(view -> robot(view, "r2").state() == RobotState.LOST);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    scriptedRobot("r2").speakAgain();
    until(view -> robot(view, "r2").pose() != null);

    long task = submit("West", "East");

    until(view -> waitReason(view, task).startsWith("Waits for r2"));
    assertEquals(RobotState.OUT_OF_SERVICE, robot(stage.fleet.snapshots().latest(), "r2").state());
  }

  @Test
  void aRobotOutOfServiceThatFallsSilentKeepsItsPlaceUntilAPersonSaysItAgain() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    scriptedRobot("r1").fallSilent();
    until(view -> view.floors().getFirst().silentRobotCells().containsKey("r1"));

    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    until(view -> view.floors().getFirst().silentRobotCells().isEmpty());
    assertEquals(
        List.of(
            "Max took r1 out of service",
            "Max took r1 out of service; it does not stand any more where it was lost"),
        history("robot.out-of-service"));
  }

  @Test
  void aRobotOutOfServiceStopsAndGoesOnWhenItIsBackInService() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    until(view -> !scriptedRobot("r1").isDriving());
    Vec2 stopped = scriptedRobot("r1").position();
    until(view -> waitReason(view, task).equals("r1 is out of service: put it back in service"));
    stage.restart(); // and it survives a restart
    until(view -> !view.robots().isEmpty() && robot(view, "r1").pose() != null);
    assertEquals(RobotState.OUT_OF_SERVICE, robot(stage.fleet.snapshots().latest(), "r1").state());
    assertEquals(
        "r1 is out of service: put it back in service",
        waitReason(stage.fleet.snapshots().latest(), task));
    assertEquals(stopped, scriptedRobot("r1").position());

    accepted(stage.fleet.putInService("r1", "Clara"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(0, scriptedRobot("r1").position().distanceTo(WEST), 1e-6);
    assertEquals(List.of("Clara put r1 back in service"), history("robot.in-service"));
    assertTrue(
        stage.store.history(task).stream()
            .anyMatch(e -> e.text().equals("Max took r1 out of service")));
  }

  @Test
  void aLoadTooHeavyForOneWaitsAndSaysWhatItNeeds() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    double most = robot(stage.fleet.snapshots().latest(), "r1").maxLoad();

    stage.scriptedRobot("r2").breakDown("BUMPER");
    until(view -> robot(view, "r2").state() == RobotState.ERROR);

    long task = submit(order(1.5 * most));

    until(
        view ->
            waitReason(view, task)
                .equals("It needs 2 robots that carry it together, and 1 of 2 is free."));
    Answer<TaskView> tooHeavy =
        stage
            .fleet
            .submit(order(3 * most), "Clara")
            .toCompletableFuture()
            .get(10, TimeUnit.SECONDS);
    assertInstanceOf(Answer.Rejected.class, tooHeavy);
  }

  @Test
  void aTaskSaysThatItsOnlyRobotIsOutOfServiceAndIsDoneWhenItIsBack() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    long task = submit("West", "East");
    until(view -> waitReason(view, task).equals("The only robot, r1, is out of service."));
    accepted(stage.fleet.putInService("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aTaskOfHigherPriorityComesFirstAlsoAfterARestart() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long first = accepted(stage.fleet.submit(order(1), "Clara")).id();
    long second = accepted(stage.fleet.submit(order(1), "Clara")).id();

    TaskView changed =
        accepted(stage.fleet.commandTask(second, new MissionEvent.Prioritise("Clara", 10)));

    assertEquals(10, changed.task().priority());
    EventRecord told = stage.store.history(second).getLast();
    assertEquals("task.prioritised", told.kind());
    assertEquals("Clara changed its priority from 0 to 10", told.text());
    accepted(stage.fleet.commandTask(second, new MissionEvent.Prioritise("Clara", 10)));
    assertEquals(told, stage.store.history(second).getLast(), "nothing to tell");
    stage.restart();
    until(view -> view.queuedCount() == 2 && task(view, second).task().priority() == 10);
    accepted(stage.fleet.putInService("r1", "Max"));
    until(view -> !task(view, second).robots().isEmpty());
    assertEquals(TaskState.QUEUED, task(stage.fleet.snapshots().latest(), first).state());
  }

  @Test
  void ofALongQueueTheFirstOnesAreShownAndAllAreCounted() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long first = accepted(stage.fleet.submit(order(1), "Clara")).id();
    for (int i = 1; i < 150; i++) {
      accepted(stage.fleet.submit(order(1), "Clara"));
    }
    TaskOrder urgent =
        new TaskOrder(
            "urgent", 1, new Where.Station("West"), new Where.Station("East"), null, 9, null, null);
    long last = accepted(stage.fleet.submit(urgent, "Clara")).id();

    until(view -> view.queuedCount() == 151 && view.tasks().size() == 100);

    FleetSnapshot view = stage.fleet.snapshots().latest();
    assertEquals(last, view.tasks().getFirst().id());
    assertEquals(first, view.tasks().getLast().id());
    accepted(stage.fleet.putInService("r1", "Max"));
    until(later -> later.tasks().stream().anyMatch(t -> t.id() == last && t.robots().size() == 1));
    assertEquals(150, stage.fleet.snapshots().latest().queuedCount());
  }

  @Test
  void aRobotIsRemovedWhenItIsOutOfServiceAndComesBackWhenItIsAdded() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit("East", "West");
    until(view -> task(view, task).state() == TaskState.CARRYING);
    assertEquals(List.of("r2"), task(stage.fleet.snapshots().latest(), task).robots());
    assertInstanceOf(Answer.Conflict.class, answer(stage.fleet.removeRobot("r2", "Max")));
    accepted(stage.fleet.takeOutOfService("r2", "Max"));
    assertInstanceOf(
        Answer.Conflict.class, answer(stage.fleet.removeRobot("r2", "Max")), "it has a task");
    accepted(stage.fleet.putInService("r2", "Max"));
    until(view -> task(view, task).state() == TaskState.DONE);
    until(view -> robot(view, "r2").task() == null);
    accepted(stage.fleet.takeOutOfService("r2", "Max"));

    accepted(stage.fleet.removeRobot("r2", "Max"));

    assertEquals(1, stage.fleet.snapshots().latest().robots().size());
    assertEquals(List.of("Max removed r2"), history("robot.removed"));
    assertInstanceOf(Answer.Unknown.class, answer(stage.fleet.removeRobot("r2", "Max")));
    stage.restart();
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    assertEquals(1, stage.fleet.snapshots().latest().robots().size());
    RobotOrder again = new RobotOrder("r2", "127.0.0.1", 1, 5, "P2", null);
    accepted(stage.fleet.addRobot(again, "Max"));
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long next = submit("East", "West");
    until(view -> task(view, next).state() == TaskState.DONE);
    assertEquals(List.of("r2"), stage.store.task(task).orElseThrow().robots(), "it is remembered");
  }

  @Test
  void aRobotIsChangedAndStaysSo() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    assertInstanceOf(
        Answer.Rejected.class,
        answer(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 1, 9, "P1"), "Max")),
        "r1 parks there");
    assertInstanceOf(
        Answer.Rejected.class,
        answer(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 1, 9, "P9"), "Max")));

    RobotView changed =
        accepted(stage.fleet.changeRobot("r2", new RobotChange("127.0.0.1", 2, 3, null), "Max"));

    assertEquals(3, changed.maxLoad());
    assertEquals(2, changed.port());
    assertNull(changed.parking());
    assertEquals(List.of("Max changed r2"), history("robot.changed"));
    stage.restart();
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    assertEquals(3, robot(stage.fleet.snapshots().latest(), "r2").maxLoad());
  }

  @Test
  void aRobotOutOfServiceGetsNoTask() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    long task = submit("West", "East"); // r1 stands nearest

    until(view -> task(view, task).robots().equals(List.of("r2")));
  }

  @Test
  void whatIsSoAlreadyIsAcceptedAndNotToldAgain() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);

    assertEquals(RobotState.IDLE, accepted(stage.fleet.putInService("r1", "Max")).state());
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    assertEquals(List.of(), history("robot.in-service"));
    assertEquals(1, history("robot.out-of-service").size());
    assertInstanceOf(
        Answer.Unknown.class,
        stage.fleet.takeOutOfService("r9", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS));
  }

  @Test
  void aDrivingRobotGoesRoundWhatAnotherOneSees() throws Exception {
    reopenWith("r2", new Vec2(14.5, 2.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(new Where.Point(new Vec2(5.5, 1.5)), new Where.Point(new Vec2(13.5, 1.5)));
    until(
        view ->
            task(view, task).state() == TaskState.CARRYING
                && !robot(view, "r1").path().isEmpty()
                && scriptedRobot("r1").isDriving());
    List<Vec2> straight = robot(stage.fleet.snapshots().latest(), "r1").path();
    assertTrue(
        straight.stream().allMatch(p -> Math.abs(p.y() - 1.5) < 1e-6), "through the obstacle");

    Cell obstacle = new Cell(11, 1);
    scriptedRobot("r2").setObstacles(GRID.centre(obstacle));

    until(
        view -> {
          assertNotEquals(obstacle, GRID.cellAt(scriptedRobot("r1").position()));
          return task(view, task).state() == TaskState.DONE;
        });
  }

  @Test
  void aRobotThatAnObstacleStopsSaysSoAndGoesOnWhenItIsGone() throws Exception {
    reopenWith("r2", new Vec2(3.5, 2.5), null);
    scriptedRobot("r2").setObstacles(DOOR);
    until(view -> obstacles(view).equals(cells(GRID.cellAt(DOOR))));

    long task = submit("West", "East");

    until(view -> waitReason(view, task).contains("an obstacle"));
    FleetSnapshot waiting = stage.fleet.snapshots().latest();
    assertTrue(waitReason(waiting, task).contains("(4.50, 1.50)"));
    String robot = task(waiting, task).robots().getFirst();
    assertEquals(waitReason(waiting, task), robot(waiting, robot).doing().english(), robot);
    scriptedRobot("r2").setObstacles();
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aRobotThatDoesNotGetOnIsToldUntilItDoes() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    scriptedRobot("r1").setStuck(true);
    until(view -> !view.floors().getFirst().standstills().isEmpty());
    FloorView.StandstillView standstill =
        stage.fleet.snapshots().latest().floors().getFirst().standstills().getFirst();
    scriptedRobot("r1").setStuck(false);
    until(view -> view.floors().getFirst().standstills().isEmpty());

    assertEquals(List.of("r1"), standstill.robots());
    untilHistory("traffic.resolved", "The standstill of r1 is over.");
    untilHistory("traffic.standstill", standstill.text().english());
    until(view -> task(view, task).state() == TaskState.DONE);
    assertTrue(
        stage.store.history(task).stream().anyMatch(e -> e.kind().equals("traffic.standstill")));
  }

  @Test
  void aChangeThatCrossesTheEndOfADriveIsNoTrouble() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    scriptedRobot("r1").endBeforeNextChange();
    until(
        view -> {
          String doing = String.valueOf(robot(view, "r1").doing());
          assertFalse(doing.contains("refused"), doing);
          return !scriptedRobot("r1").isAwaitingChange()
              && task(view, task).state() == TaskState.DONE;
        });
  }

  // --- cancel, hold, pause, failures ------------------------------------------------------------

  @Test
  void aDrivingRobotIsNotToldWhereItIs() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.CARRYING && scriptedRobot("r1").isDriving());

    Answer<RobotView> answer =
        stage.fleet.locateRobot("r1", new Pose(1.5, 1.5, 0), "Max").toCompletableFuture().get();

    assertInstanceOf(Answer.Rejected.class, answer);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aTaskCancelledBeforeThePickUpEndsAndItsRobotGoesHome() throws Exception {
    long task = submit("East", "West");
    until(
        view -> task(view, task).state() == TaskState.TO_OBJECT && scriptedRobot("r1").isDriving());

    TaskView cancelled =
        accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));

    assertEquals(TaskState.CANCELLED, cancelled.state());
    until(
        view ->
            !scriptedRobot("r1").isDriving()
                && scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
    assertEquals(List.of("Cancelled by Max"), history("task.cancelled"));
    assertEquals(TaskState.CANCELLED, stage.store.task(task).orElseThrow().state());
  }

  @Test
  void aQueuedTaskIsHeldAndCancelledWithoutARobot() throws Exception {
    until(view -> robot(view, "r1").state() == RobotState.IDLE);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));
    long task = submit("East", "West");

    assertTrue(accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max"))).held());
    stage.restart(); // and it survives a restart
    accepted(stage.fleet.putInService("r1", "Max"));
    until(view -> robot(view, "r1").state() == RobotState.IDLE && task(view, task).held());
    assertEquals("On hold.", waitReason(stage.fleet.snapshots().latest(), task));
    TaskView cancelled =
        accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));

    assertEquals(TaskState.CANCELLED, cancelled.state());
    until(view -> task(view, task).state() == TaskState.CANCELLED);
    assertInstanceOf(
        Answer.Conflict.class, answer(stage.fleet.commandTask(task, new MissionEvent.Hold("Max"))));
  }

  @Test
  void withTheLoadOnBoardCancelAsksAndSetsItDownWhereTheRobotStops() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    Answer<TaskView> asked =
        answer(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", null)));
    assertEquals(
        List.of("here", "back"),
        Objects.requireNonNull(assertInstanceOf(Answer.Conflict.class, asked).needs()).answers());
    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));

    until(view -> task(view, task).state() == TaskState.CANCELLED);
    Vec2 place =
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).loadAt()).position();
    assertTrue(place.x() > 0.5 && place.x() < 8.5, "on the way: " + place);
    until(view -> scriptedRobot("r1").position().distanceTo(WEST) < 1e-6);
    TaskView stored = stage.store.task(task).orElseThrow();
    assertEquals(0, Objects.requireNonNull(stored.loadAt()).position().distanceTo(place), 1e-9);
  }

  @Test
  void withTheLoadOnBoardCancelBringsItBack() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.BACK)));

    until(view -> task(view, task).state() == TaskState.CANCELLED);
    assertEquals(0, scriptedRobot("r1").position().distanceTo(new Vec2(0.5, 2.5)), 1e-6);
    until(
        view ->
            stage.store.history(task).stream()
                .anyMatch(e -> e.text().equals("Brought back to West")));
  }

  @Test
  void whatIsDeliveredIsNotCancelled() throws Exception {
    long task = submit("West", "East");
    until(view -> task(view, task).state() == TaskState.RETURNING);

    Answer<TaskView> no =
        answer(stage.fleet.commandTask(task, new MissionEvent.Cancel("Max", LoadChoice.HERE)));

    assertInstanceOf(Answer.Conflict.class, no);
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aTaskOnHoldStandsAndSaysSoAndGoesOnAfterARestart() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    assertTrue(accepted(stage.fleet.commandTask(task, new MissionEvent.Hold("Max"))).held());
    until(view -> scriptedRobot("r1").isHeld() && robot(view, "r1").state() == RobotState.HOLDING);
    Vec2 stopped = scriptedRobot("r1").position();
    stage.restart();
    until(view -> !view.robots().isEmpty() && robot(view, "r1").state() == RobotState.HOLDING);
    assertTrue(task(stage.fleet.snapshots().latest(), task).held());
    assertEquals(
        "Task " + task + " is on hold", waitReason(stage.fleet.snapshots().latest(), task));
    assertEquals(stopped, scriptedRobot("r1").position());

    accepted(stage.fleet.commandTask(task, new MissionEvent.Resume("Max")));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("Max put it on hold"), history("task.held"));
    assertEquals(List.of("Max let it go on"), history("task.resumed"));
  }

  @Test
  void aRobotOnHoldStandsUntilItIsLetGoOn() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    assertTrue(accepted(stage.fleet.holdRobot("r1", "Max")).held());
    until(view -> robot(view, "r1").state() == RobotState.HOLDING);
    stage.restart();
    until(view -> !view.robots().isEmpty() && robot(view, "r1").held());
    assertEquals(TaskState.CARRYING, task(stage.fleet.snapshots().latest(), task).state());
    accepted(stage.fleet.resumeRobot("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("Max put r1 on hold"), history("robot.held"));
  }

  @Test
  void whileAFloorIsOnHoldItsRobotsStandAlsoAfterARestart() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    assertEquals(
        new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with("attic")),
        stage.fleet.holdFloor("attic", "Max").toCompletableFuture().get(10, TimeUnit.SECONDS));

    assertEquals("Max", accepted(stage.fleet.holdFloor("hall", "Max")).orElseThrow().user());
    until(view -> robot(view, "r1").state() == RobotState.HOLDING);
    Vec2 stopped = scriptedRobot("r1").position();
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.HOLDING));
    FleetSnapshot held = stage.fleet.snapshots().latest();
    assertEquals("Max", Objects.requireNonNull(held.floors().getFirst().hold()).user());
    assertEquals(Phrase.FLOOR_HELD_BY.with("hall", "Max"), robot(held, "r1").doing());
    assertEquals(Phrase.FLOOR_HELD_BY.with("hall", "Max"), task(held, task).waitingFor());
    assertEquals(stopped, scriptedRobot("r1").position());

    assertEquals(Optional.empty(), accepted(stage.fleet.resumeFloor("hall", "Boss")));

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("Max put all robots of hall on hold"), history("floor.held"));
    assertEquals(List.of("Boss let the robots of hall go on"), history("floor.resumed"));
  }

  @Test
  void whileAllArePausedNoRobotDrivesAndOneThatConnectsIsHeldToo() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);

    assertEquals("Max", accepted(stage.fleet.pauseAll("Max")).orElseThrow().user());
    until(view -> scriptedRobot("r1").isHeld());
    Vec2 stopped = scriptedRobot("r1").position();
    reopenWith("r2", EAST, "P2");
    until(
        view ->
            scriptedRobot("r2").isHeld()
                && view.robots().stream().allMatch(r -> r.state() == RobotState.HOLDING));
    assertEquals("Max", Objects.requireNonNull(stage.fleet.snapshots().latest().pause()).user());
    assertEquals(stopped, scriptedRobot("r1").position());
    assertEquals(
        Phrase.ALL_PAUSED_BY.with("Max"), robot(stage.fleet.snapshots().latest(), "r1").doing());

    accepted(stage.fleet.resumeAll("Boss"));

    until(view -> task(view, task).state() == TaskState.DONE && view.pause() == null);
    assertEquals(List.of("Max paused all robots"), history("fleet.paused"));
    assertEquals(List.of("Boss let all robots go on"), history("fleet.resumed"));
  }

  @Test
  void theTaskOfARobotThatFailsBeforeThePickUpGoesToAnotherAtOnce() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(IN_THE_MIDDLE, new Where.Station("West"));
    until(view -> task(view, task).robots().equals(List.of("r1")));

    scriptedRobot("r1").breakDown("BUMPER");

    until(view -> task(view, task).robots().equals(List.of("r2")));
    assertTrue(
        history("task.robot-failed")
            .contains("r1 reports the error BUMPER; another robot is looked for"));
  }

  @Test
  void aLostRobotsTaskWaitsThenGoesToAnotherAndTheLostOneIsCancelledFirst() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(IN_THE_MIDDLE, new Where.Station("West"));
    until(
        view -> task(view, task).state() == TaskState.TO_OBJECT && scriptedRobot("r1").isDriving());
    scriptedRobot("r1").loseConnection();
    Instant lost = stage.now;
    until(view -> task(view, task).needs() != null);
    assertEquals(
        List.of("another robot", "wait"),
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).needs()).answers());

    until(view -> task(view, task).robots().equals(List.of("r2")));

    assertTrue(!stage.now.isBefore(lost.plus(FleetStage.REASSIGN_AFTER)), "not before 30 s");
    assertTrue(
        stage.fleet.snapshots().latest().floors().getFirst().silentRobotCells().containsKey("r1"));
    int told = scriptedRobot("r1").obeyed().size();
    scriptedRobot("r1").speakAgain();
    until(view -> scriptedRobot("r1").obeyed().size() > told);
    assertInstanceOf(ServerMessage.Cancel.class, scriptedRobot("r1").obeyed().get(told));
    until(view -> task(view, task).state() == TaskState.DONE);
  }

  @Test
  void aLostRobotsTaskGoesToAnotherAtOnceByAPersonsWord() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit(IN_THE_MIDDLE, new Where.Station("West"));
    until(view -> task(view, task).robots().equals(List.of("r1")));
    scriptedRobot("r1").fallSilent();
    Instant lost = stage.now;
    until(view -> task(view, task).needs() != null);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.ANOTHER)));

    until(view -> task(view, task).robots().equals(List.of("r2")));
    assertTrue(
        stage.now.isBefore(lost.plus(FleetStage.REASSIGN_AFTER)), "before the 30 s are over");
  }

  @Test
  void aRobotThatFailsWithTheLoadLetsAPersonDecideAndAnotherFetchesIt() throws Exception {
    reopenWith("r2", new Vec2(14.5, 0.5), null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").breakDown("BUMPER");
    until(view -> task(view, task).needs() != null);
    Vec2 place =
        Objects.requireNonNull(task(stage.fleet.snapshots().latest(), task).loadAt()).position();
    assertEquals(scriptedRobot("r1").position(), place);
    stage.restart(); // the question survives a restart
    until(view -> !view.tasks().isEmpty() && task(view, task).needs() != null);

    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.ANOTHER)));
    until(view -> task(view, task).robots().equals(List.of("r2")));
    scriptedRobot("r1").fallSilent(); // it is carried away
    until(view -> robot(view, "r1").state() == RobotState.LOST);
    accepted(stage.fleet.takeOutOfService("r1", "Max"));

    until(view -> task(view, task).state() == TaskState.CARRYING);
    until(view -> task(view, task).state() == TaskState.DONE);
    assertTrue(
        stage.store.history(task).stream()
            .anyMatch(e -> e.text().equals("Picked up at " + new TaskPlace(place, null).text())));
  }

  @Test
  void aRobotThatFailsWithTheLoadAndIsMendedGoesOn() throws Exception {
    long task = submit("West", "East");
    untilCarryingOnTheWay(task);
    scriptedRobot("r1").breakDown("BUMPER");
    until(view -> task(view, task).needs() != null);
    accepted(stage.fleet.commandTask(task, new MissionEvent.Answer("Max", Reply.WAIT)));
    until(view -> task(view, task).needs() == null);

    scriptedRobot("r1").repair();

    until(view -> task(view, task).state() == TaskState.DONE);
    assertEquals(List.of("r1 can go on"), history("task.robot-back"));
  }

  @Test
  void aRobotThatFailsOnItsWayHomeHasDoneItsTask() throws Exception {
    long task = submit("West", "East");
    until(
        view -> task(view, task).state() == TaskState.RETURNING && scriptedRobot("r1").isDriving());

    scriptedRobot("r1").breakDown("BUMPER");

    until(view -> task(view, task).state() == TaskState.DONE);
    assertTrue(scriptedRobot("r1").position().distanceTo(WEST) > 0.5, "it did not get home");
  }

  @Test
  void anIdleRobotAwayFromItsParkingPointGoesHome() throws Exception {
    reopenWith("r2", new Vec2(12.5, 2.5), "P2");

    until(view -> robot(view, "r2").state() == RobotState.IDLE);
    until(view -> scriptedRobot("r2").position().distanceTo(EAST) < 1e-6);
  }

  @Test
  void aPersonSendsAnIdleRobotHomeAndNoOther() throws Exception {
    reopenWith("r2", new Vec2(12.5, 2.5), "P2");
    reopenWith("r3", DOOR, null);
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));

    assertEquals(Phase.NONE, accepted(stage.fleet.sendHome("r2", "Max")).phase());
    assertInstanceOf(Answer.Conflict.class, answer(stage.fleet.sendHome("r3", "Max")));
    assertInstanceOf(Answer.Unknown.class, answer(stage.fleet.sendHome("r9", "Max")));

    until(view -> scriptedRobot("r2").position().distanceTo(EAST) < 1e-6);
    assertEquals(List.of("Max sent r2 home"), history("robot.sent-home"));
  }

  private void untilCarryingOnTheWay(long task) throws InterruptedException {
    until(
        view ->
            task(view, task).state() == TaskState.CARRYING
                && scriptedRobot("r1").isDriving()
                && scriptedRobot("r1").position().distanceTo(new Vec2(0.5, 2.5)) > 0.9);
  }

  private static <T> Answer<T> answer(CompletionStage<Answer<T>> answer) throws Exception {
    return answer.toCompletableFuture().get(10, TimeUnit.SECONDS);
  }

  // --- the stage --------------------------------------------------------------------------------

  private void reopenWith(String name, Vec2 at, @Nullable String parking) {
    stage.add(name, at, parking);
    stage.restart();
  }

  private void until(Predicate<FleetSnapshot> condition) throws InterruptedException {
    stage.await(condition);
  }

  /** What no answer waits for is written a moment later. */
  private void untilHistory(String kind, String sentence) throws InterruptedException {
    until(view -> history(kind).equals(List.of(sentence)));
  }

  private long submit(String start, String goal) throws Exception {
    return submit(new Where.Station(start), new Where.Station(goal));
  }

  /** From west to east. */
  private static TaskOrder order(double load) {
    return new TaskOrder(
        "box", load, new Where.Station("West"), new Where.Station("East"), null, 0, null, null);
  }

  private long submit(Where start, Where goal) throws Exception {
    return submit(new TaskOrder("box", 1, start, goal, null, 0, null, null));
  }

  private long submit(TaskOrder order) throws Exception {
    long id = accepted(stage.fleet.submit(order, "Clara")).id();
    until(view -> view.tasks().stream().anyMatch(t -> t.id() == id));
    return id;
  }

  private static <T> T accepted(CompletionStage<Answer<T>> pending) throws Exception {
    Answer<T> answer = pending.toCompletableFuture().get(10, TimeUnit.SECONDS);
    return answer instanceof Answer.Accepted<T>(T value) ? value : fail("No: " + answer);
  }

  private ScriptedRobot scriptedRobot(String name) {
    return stage.scriptedRobot(name);
  }

  private static RobotView robot(FleetSnapshot view, String name) {
    return view.robots().stream().filter(r -> r.name().equals(name)).findFirst().orElseThrow();
  }

  private static TaskView task(FleetSnapshot view, long id) {
    return view.tasks().stream().filter(t -> t.id() == id).findFirst().orElseThrow();
  }

  private static String waitReason(FleetSnapshot view, long task) {
    return Objects.toString(task(view, task).waitingFor(), "");
  }

  private static CellRuns obstacles(FleetSnapshot view) {
    return view.floors().getFirst().obstacles();
  }

  private static CellRuns cells(Cell cell) {
    BitSet bits = new BitSet();
    bits.set(GRID.index(cell));
    return CellRuns.of(bits);
  }

  private List<String> history(String kind) {
    return stage
        .database
        .jdbi()
        .withHandle(
            h ->
                h.createQuery("select text from events where kind = :kind order by id")
                    .bind("kind", kind)
                    .mapTo(String.class)
                    .list());
  }
}
