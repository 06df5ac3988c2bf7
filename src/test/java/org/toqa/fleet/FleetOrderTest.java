package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TaskState;
import org.toqa.store.JdbiOrderArchive;

/** Orders that are carried as several tasks: pieces, and loads that go from stop to stop. */
class FleetOrderTest extends HallFleetTest {
  private static final Where WEST_STATION = new Where.Station("West");
  private static final Where EAST_STATION = new Where.Station("East");

  @Test
  void piecesAreCarriedBesideEachOtherAndOneOfAFailedRobotIsPlannedAnew() throws Exception {
    reopenWith("r2", EAST, "P2");
    until(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));
    List<Long> pieces =
        submit(
            new PartsOrder(
                "bolts",
                OrderPart.Kind.PIECES,
                Stream.generate(() -> leg("bolts", IN_THE_MIDDLE, WEST_STATION))
                    .limit(3)
                    .toList()));
    until(
        view ->
            view.tasks().stream().filter(t -> !t.robots().isEmpty()).count() == 2
                && view.tasks().stream().anyMatch(t -> t.robots().equals(List.of("r2"))));

    scriptedRobot("r2").breakDown("BUMPER");
    until(view -> order().delivered() == 1);
    assertEquals(OrderState.IN_PROGRESS, order().state());
    stage.restart(); // nothing is lost, and nothing is there twice
    until(view -> order().state() == OrderState.DONE);

    OrderView done = order();
    assertEquals(pieces, done.tasks().stream().map(TaskView::id).toList());
    assertEquals(3, done.delivered());
    assertTrue(done.tasks().stream().allMatch(t -> t.robots().equals(List.of("r1"))));
    assertEquals(3, stage.store.count());
  }

  @Test
  void aLegBeginsWhereTheOneBeforeHasEndedAlsoAfterARestart() throws Exception {
    List<Long> legs = submit(roundTrip());
    long first = legs.getFirst();
    long second = legs.get(1);
    until(view -> task(view, first).state() == TaskState.CARRYING);
    assertEquals(
        "Leg 1 of 2 (task " + first + ") has to be delivered first.",
        waitReason(stage.fleet.snapshots().latest(), second));
    assertInstanceOf(
        Answer.Conflict.class,
        answer(stage.fleet.commandTask(second, new MissionEvent.Resume("Clara"))));
    assertInstanceOf(
        Answer.Conflict.class,
        answer(stage.fleet.editTask(second, leg("x", WEST_STATION, IN_THE_MIDDLE), null, "Clara")));

    stage.restart();
    until(
        view -> {
          TaskState before = task(view, first).state();
          assertTrue(before.isDelivered() || task(view, second).robots().isEmpty());
          return before.isDelivered();
        });
    stage.restart();
    until(view -> order().delivered() == 1 && !task(view, second).robots().isEmpty());
    assertInstanceOf(
        Answer.Conflict.class,
        answer(stage.fleet.deleteTask(stage.store.task(first).orElseThrow(), "Clara")),
        "its order has not ended");
    until(view -> order().state() == OrderState.DONE);
    assertEquals(0, order().stuck().size());
  }

  @Test
  void aLegThatIsCancelledStopsTheRestUntilItIsOrderedAgainFromWhereItsLoadIs() throws Exception {
    List<Long> legs = submit(roundTrip());
    untilCarryingOnTheWay(legs.getFirst());
    accepted(
        stage.fleet.commandTask(
            legs.getFirst(), new MissionEvent.Cancel("Clara", LoadChoice.HERE)));
    until(view -> task(view, legs.getFirst()).state() == TaskState.CANCELLED);
    stage.restart();
    until(
        view -> robot(view, "r1").state() == RobotState.IDLE && task(view, legs.get(1)).blocked());
    String why = waitReason(stage.fleet.snapshots().latest(), legs.get(1));
    assertTrue(why.contains("has ended without delivery"), why);
    assertEquals(OrderState.STOPPED, order().state());
    assertEquals(legs.get(1), order().stuck().getFirst().task().id());

    PartsToRetry again = PartsToRetry.of(order());
    assertInstanceOf(
        BatchAnswer.Accepted.class,
        stage
            .fleet
            .submitAll(
                again.orders(), again.parts(), Orderer.named("Clara"), List.of(UUID.randomUUID()))
            .toCompletableFuture()
            .get(10, TimeUnit.SECONDS));

    until(view -> order().state() == OrderState.DONE);
    assertEquals(3, order().tasks().size());
    assertEquals(2, order().delivered());
    until(view -> view.floors().getFirst().leftLoads().isEmpty());
  }

  @Test
  void aPersonLetsALegBeginWhoseLoadHeHasBroughtThere() throws Exception {
    List<Long> legs = submit(roundTrip());
    accepted(stage.fleet.commandTask(legs.getFirst(), new MissionEvent.Cancel("Clara", null)));
    until(view -> task(view, legs.get(1)).blocked());

    accepted(stage.fleet.commandTask(legs.get(1), new MissionEvent.Resume("Clara", true)));
    assertEquals(List.of(), history("task.resumed"), "meant for what is on hold");
    accepted(stage.fleet.commandTask(legs.get(1), new MissionEvent.Resume("Clara")));
    stage.restart();

    until(view -> task(view, legs.get(1)).state() == TaskState.DONE);
    assertEquals(
        List.of("Clara let this leg begin, though leg 1 was not delivered"),
        history("task.resumed"));
    assertEquals(OrderState.CANCELLED, order().state());
    assertEquals(1, order().delivered());
    assertEquals(List.of(), PartsToRetry.of(order()).orders(), "it was carried by hand");
  }

  private static PartsOrder roundTrip() {
    return new PartsOrder(
        "tour",
        OrderPart.Kind.STOPS,
        List.of(leg("tour", WEST_STATION, EAST_STATION), leg("tour", EAST_STATION, IN_THE_MIDDLE)));
  }

  private static TaskOrder leg(String name, Where start, Where goal) {
    return new TaskOrder(name, 1, start, goal, null, 0, null, null);
  }

  /** The ids of its tasks. */
  private List<Long> submit(PartsOrder order) throws Exception {
    BatchAnswer answer =
        stage
            .fleet
            .submitAll(
                order.tasks(),
                order.parts(),
                Orderer.named("Clara"),
                order.tasks().stream().map(_ -> UUID.randomUUID()).toList())
            .toCompletableFuture()
            .get(10, TimeUnit.SECONDS);
    List<TaskView> tasks = assertInstanceOf(BatchAnswer.Accepted.class, answer).tasks();
    until(view -> view.tasks().size() >= tasks.size());
    return tasks.stream().map(TaskView::id).toList();
  }

  /** The only one, with what the fleet knows of its tasks. */
  private OrderView order() {
    FleetSnapshot latest = stage.fleet.snapshots().latest();
    return new JdbiOrderArchive(stage.database.jdbi())
        .orders(0, 10)
        .getFirst()
        .withTasks(
            stored ->
                latest.tasks().stream()
                    .filter(live -> live.id() == stored.id())
                    .findFirst()
                    .orElse(stored));
  }
}
