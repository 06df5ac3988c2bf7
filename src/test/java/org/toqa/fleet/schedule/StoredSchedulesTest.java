package org.toqa.fleet.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetStage;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.ScheduleStore;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.store.JdbiScheduleStore;

/** Changes of schedules that come at once. */
@Timeout(60)
class StoredSchedulesTest {
  private static final int MAX_SCHEDULES = 500;
  private static final TaskOrder ORDER =
      new TaskOrder(
          "box",
          1,
          new Where.Station("Goods-in 1"),
          new Where.Station("Mill"),
          null,
          0,
          null,
          null);
  private final Recurrence hourly =
      new Recurrence.Every(
          Instant.now().plus(1, ChronoUnit.HOURS).truncatedTo(ChronoUnit.SECONDS),
          Duration.ofHours(1));

  private FleetStage stage;
  private JdbiScheduleStore store;

  @BeforeEach
  void start() throws Exception {
    stage = new FleetStage(FloorReader.read(Path.of("maps", "lab.yaml")));
    store = new JdbiScheduleStore(stage.database.jdbi());
  }

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void oneKeyMakesOneScheduleHoweverManyComeAtOnce() throws Exception {
    UUID key = UUID.randomUUID();

    List<KeyedAnswer<Schedule>> answers = atOnce(8, () -> add(ORDER, key));

    Schedule stored = store.scheduleByKey(key).orElseThrow();
    assertEquals(List.of(stored), store.schedules());
    for (KeyedAnswer<Schedule> answer : answers) {
      assertEquals(stored, scheduleOf(answer));
    }
    assertInstanceOf(
        KeyedAnswer.KeyReused.class,
        await(
            stage.fleet.schedules().add(ORDER, hourly, Instant.now().plusSeconds(9000), "c", key)));
  }

  @Test
  void theLastPlaceIsTakenOnce() throws Exception {
    Schedule one = Schedule.of(ORDER, hourly, null, Orderer.named("Clara"), Instant.now());
    for (int i = 1; i < MAX_SCHEDULES; i++) {
      store.add(one, UUID.randomUUID());
    }

    List<KeyedAnswer<Schedule>> answers = atOnce(6, () -> add(ORDER, UUID.randomUUID()));

    assertEquals(
        1,
        answers.stream()
            .filter(
                a ->
                    a instanceof KeyedAnswer.Answered<Schedule>(var answer)
                        && answer instanceof Answer.Accepted<Schedule>)
            .count());
    assertEquals(MAX_SCHEDULES, store.schedules().size());
  }

  @Test
  void whatIsDeletedTwiceIsDeletedOnce() throws Exception {
    long id = scheduleOf(await(add(ORDER, UUID.randomUUID()))).id();

    List<Answer<Schedule>> answers = atOnce(2, () -> stage.fleet.schedules().delete(id, "Clara"));

    assertEquals(1, answers.stream().filter(a -> a instanceof Answer.Accepted<Schedule>).count());
    assertEquals(1, answers.stream().filter(a -> a instanceof Answer.Unknown<Schedule>).count());
  }

  @Test
  void whatIsPausedIsAnsweredAsItIsStored() throws Exception {
    long id = scheduleOf(await(add(ORDER, UUID.randomUUID()))).id();

    Answer<Schedule> paused = await(stage.fleet.schedules().pause(id, "Clara"));
    Answer<Schedule> resumed = await(stage.fleet.schedules().resume(id, "Clara"));

    assertTrue(paused instanceof Answer.Accepted<Schedule>(var it) && it.paused());
    assertEquals(new Answer.Accepted<>(store.schedule(id).orElseThrow()), resumed);
  }

  @Test
  void noMapWithoutItsStationComesInForceBeforeItIsStored() throws Exception {
    FloorEditing editing = stage.fleet.floorEditing();
    FloorMap lab = stage.fleet.floors().getFirst();
    FloorDrawing bare = FloorDrawing.of(lab.drawing().walls());
    long seen = editing.draft(lab.name()).orElseThrow().revision();
    long draft = accepted(editing.saveDraft(lab.name(), bare, seen, "Max")).revision();
    List<CompletableFuture<Answer<FloorMap>>> published = new ArrayList<>();
    ScheduleStore slow =
        whenAdding(
            () -> {
              published.add(editing.publish(lab.name(), draft, "Max").toCompletableFuture());
              try {
                published.getFirst().copy().get(1, TimeUnit.SECONDS);
              } catch (TimeoutException e) { // it waits for the schedule, as it should
              }
              return null;
            });

    KeyedAnswer<Schedule> added =
        await(
            new StoredSchedules(slow, stage.fleet, Instant::now)
                .add(ORDER, hourly, null, "Clara", UUID.randomUUID()));

    assertEquals(store.schedules(), List.of(scheduleOf(added)));
    Answer<FloorMap> answer = await(published.getFirst());
    assertTrue(
        answer instanceof Answer.Conflict<FloorMap>(var why, var _)
            && why.english().contains("The schedule box uses the station Mill."),
        answer::toString);
  }

  /** The store, before which something is done each time that a schedule is added. */
  private ScheduleStore whenAdding(Callable<?> before) {
    return (ScheduleStore)
        Proxy.newProxyInstance(
            ScheduleStore.class.getClassLoader(),
            new Class<?>[] {ScheduleStore.class},
            (_, method, arguments) -> {
              if (method.getName().equals("add")) {
                before.call();
              }
              return method.invoke(store, arguments);
            });
  }

  private static <T> T accepted(CompletionStage<Answer<T>> answer) throws Exception {
    return ((Answer.Accepted<T>) await(answer)).value();
  }

  private CompletionStage<KeyedAnswer<Schedule>> add(TaskOrder order, UUID key) {
    return stage.fleet.schedules().add(order, hourly, null, "Clara", key);
  }

  private static Schedule scheduleOf(KeyedAnswer<Schedule> answer) {
    return switch (answer) {
      case KeyedAnswer.Answered<Schedule>(Answer.Accepted<Schedule>(Schedule schedule)) -> schedule;
      case KeyedAnswer.Repeated<Schedule>(Schedule schedule) -> schedule;
      default -> throw new AssertionError(answer);
    };
  }

  private static <T> List<T> atOnce(int count, Supplier<CompletionStage<T>> change)
      throws Exception {
    List<CompletionStage<T>> answers = Stream.generate(change).limit(count).toList();
    List<T> all = new ArrayList<>();
    for (CompletionStage<T> answer : answers) {
      all.add(await(answer));
    }
    return all;
  }

  private static <T> T await(CompletionStage<T> answer) throws Exception {
    return answer.toCompletableFuture().get(20, TimeUnit.SECONDS);
  }
}
