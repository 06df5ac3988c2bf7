package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.CheckRefusedException.Reason;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/** Whose turn it is, on one thread and by a clock that only the test moves. */
class OrderChecksTest {
  private static final int PER_USER = 8;

  private final Queue<Runnable> threads = new ArrayDeque<>();
  private final AtomicLong nanos = new AtomicLong();
  private final OrderChecks checks = new OrderChecks(threads::add, PER_USER, nanos::get);
  private final List<String> done = new ArrayList<>();

  @Test
  void aFloodOfOneUserComesBetweenNobodyElsesOrderAndItsCheckMoreThanOnce() {
    for (int i = 0; i < PER_USER; i++) {
      var _ = order("Flood");
    }
    var _ = order("Clara");
    var _ = order("Max");

    threads.forEach(Runnable::run);

    assertEquals(List.of("Flood", "Clara", "Max", "Flood"), done.subList(0, 4));
    assertEquals(PER_USER + 2, done.size());
  }

  @Test
  void whatTheFleetAsksHasItsTurnToo() {
    for (int i = 0; i < PER_USER; i++) {
      var _ = order("Flood");
    }
    checks.fleetExecutor().execute(() -> done.add("fleet"));

    threads.forEach(Runnable::run);

    assertEquals(List.of("Flood", "fleet"), done.subList(0, 2));
  }

  @Test
  void aUserHasSoManyAtOnceAndThenHisNextWhenOneHasEnded() {
    List<OrderChecks.Check> open = new ArrayList<>();
    for (int i = 0; i < PER_USER; i++) {
      open.add(checks.begin("Clara"));
    }

    assertEquals(
        Reason.TOO_MANY,
        assertThrows(CheckRefusedException.class, () -> checks.begin("Clara")).reason());
    checks.begin("Max").close();
    open.getFirst().close();
    open.getFirst().close(); // counts once
    checks.begin("Clara");
    assertThrows(CheckRefusedException.class, () -> checks.begin("Clara"));
  }

  @Test
  void whatHasWaitedTooLongIsNotDoneAnyMore() {
    CompletableFuture<?> waiting = order("Clara");

    nanos.addAndGet(OrderChecks.LIMIT.toNanos());
    threads.forEach(Runnable::run);

    assertEquals(List.of(), done);
    assertOutOfTime(waiting);
  }

  /** A search that would look at a million cells looks at few more once its time is over. */
  @Test
  void aSearchIsEndedWhenItsTimeIsOver() {
    AtomicInteger looks = new AtomicInteger();
    OrderChecks running =
        new OrderChecks(
            Runnable::run,
            PER_USER,
            () -> looks.incrementAndGet() > 10 ? Duration.ofDays(1).toNanos() : 0);
    PathQuery paths = new PathQuery(Runnable::run);
    OccupancyGrid grid = new OccupancyGrid(1000, 1000, 0.05, Vec2.ZERO, comb(1000));

    CompletableFuture<FloorPath> search =
        paths.findPath(
            grid, new Vec2(0.5, 0.5), new Vec2(49.5, 49.5), 0.255, running.begin("Clara"));

    assertOutOfTime(search);
    assertTrue(looks.get() < 20, looks::toString);
    assertFalse(
        paths
            .findPath(
                grid,
                new Vec2(0.5, 0.5),
                new Vec2(49.5, 49.5),
                0.255,
                new OrderChecks(Runnable::run, 1, () -> 0).begin("Clara"))
            .isCompletedExceptionally(),
        "the next who asks is answered");
  }

  /**
   * Walls from north and south by turns, so that the way leads round each, and between them rows of
   * posts, beside each of which a path may turn.
   */
  private static BitSet comb(int size) {
    BitSet walls = new BitSet();
    for (int column = 50; column < size; column += 50) {
      boolean isFromSouth = column % 100 == 0;
      for (int row = isFromSouth ? 0 : 50; row < (isFromSouth ? size - 50 : size); row++) {
        walls.set(row * size + column);
      }
      for (int row = 0; row < size; row += 20) {
        walls.set(row * size + column - 25);
      }
    }
    return walls;
  }

  private CompletableFuture<?> order(String user) {
    return checks.begin(user).run(() -> done.add(user));
  }

  private static void assertOutOfTime(CompletableFuture<?> result) {
    CompletionException failure = assertThrows(CompletionException.class, result::join);
    assertEquals(
        Reason.OUT_OF_TIME,
        assertInstanceOf(CheckRefusedException.class, failure.getCause()).reason());
  }
}
