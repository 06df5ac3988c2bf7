package org.toqa.fleet.schedule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetStage;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
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
