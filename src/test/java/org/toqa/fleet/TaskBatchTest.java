package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.allocation.Policy;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorReader;
import org.toqa.mission.OrderPart;
import org.toqa.persistence.StoreException;
import org.toqa.store.JdbiOrderArchive;

/** Orders of which all are wanted or none. */
@Timeout(120)
class TaskBatchTest {
  private final AtomicBoolean dies = new AtomicBoolean();
  private FleetStage stage;

  @BeforeEach
  void start() throws Exception {
    stage =
        new FleetStage(
            FloorReader.read(Path.of("maps", "lab.yaml")),
            ChargingRules.USUAL,
            Policy.OPTIMAL.method(),
            store ->
                TamperedStore.of(
                    store,
                    (method, arguments, call) -> {
                      Object stored = call.go();
                      if (method.equals("addTasks") && dies.get()) {
                        throw new StoreException("It was stored, but nobody knows.", null);
                      }
                      return stored;
                    }));
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void allAreQueuedInTheirOrderAndOutliveARestart() throws Exception {
    List<TaskOrder> orders = List.of(order("a", "Mill"), order("b", "Store A"), order("c", "Mill"));

    BatchAnswer.Accepted accepted =
        assertInstanceOf(BatchAnswer.Accepted.class, submit(orders, keys(3)));

    assertEquals(
        List.of("a", "b", "c"), accepted.tasks().stream().map(t -> t.task().name()).toList());
    stage.restart();
    assertEquals(
        accepted.tasks().stream().map(TaskView::id).toList(),
        stage.store.openTasks().stream().map(t -> t.mission().id()).toList());
  }

  @Test
  void ofOneThatIsRefusedNoneIsStored() throws Exception {
    TaskOrder inTheWall =
        new TaskOrder(
            "wall",
            1,
            new Where.Point(new Vec2(-500, 0)),
            new Where.Station("Mill"),
            null,
            0,
            null,
            null);
    List<TaskOrder> orders =
        List.of(order("a", "Mill"), order("b", "Nowhere"), order("c", "Mill"), inTheWall);

    BatchAnswer.Rejected refused =
        assertInstanceOf(BatchAnswer.Rejected.class, submit(orders, keys(4)));

    assertEquals(
        List.of("1 goal", "3 start"),
        refused.rejections().stream().map(r -> r.index() + " " + r.field()).toList());
    assertTrue(
        refused
            .rejections()
            .getFirst()
            .sentence()
            .english()
            .contains("There is no station Nowhere"));
    assertEquals(
        refused.rejections(), await(stage.fleet.rejections(orders, "Clara")), "only looked at");
    assertEquals(0, stage.store.count());
  }

  @Test
  void whatWasNotAnsweredAsStoredIsNotThereLater() throws Exception {
    dies.set(true);
    List<TaskOrder> orders = List.of(order("a", "Mill"), order("b", "Mill"));
    PartsOrder pieces = new PartsOrder("pieces", OrderPart.Kind.PIECES, orders);
    List<UUID> keys = keys(2);

    ExecutionException refused =
        assertThrows(
            ExecutionException.class,
            () ->
                await(stage.fleet.submitAll(orders, pieces.parts(), Orderer.named("Clara"), keys)));

    assertInstanceOf(StoreException.class, refused.getCause());
    dies.set(false);
    assertInstanceOf(BatchAnswer.Accepted.class, submit(orders, keys));
    assertEquals(2, stage.store.count());
    assertEquals(0, new JdbiOrderArchive(stage.database.jdbi()).orderCount());
  }

  private BatchAnswer submit(List<TaskOrder> orders, List<UUID> keys) throws Exception {
    return await(stage.fleet.submitAll(orders, "Clara", keys));
  }

  private static <T> T await(CompletionStage<T> answer) throws Exception {
    return answer.toCompletableFuture().get(20, TimeUnit.SECONDS);
  }

  private static List<UUID> keys(int count) {
    return Stream.generate(UUID::randomUUID).limit(count).toList();
  }

  private static TaskOrder order(String name, String goal) {
    return new TaskOrder(
        name, 1, new Where.Station("Goods-in 1"), new Where.Station(goal), null, 0, null, null);
  }
}
