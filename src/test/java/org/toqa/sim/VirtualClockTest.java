package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class VirtualClockTest {

  private static final Instant EPOCH = Instant.parse("2026-01-01T00:00:00Z");
  private static final Duration STEP = VirtualClock.STEP;
  private static final long STEP_NANOS = STEP.toNanos();

  @Test
  void participantsTickInTheirOrderEachAtItsOwnPeriod() {
    try (VirtualClock clock = new VirtualClock(EPOCH, 1)) {
      List<String> ticks = new ArrayList<>();
      clock.add(nanos -> ticks.add("robot " + nanos / STEP_NANOS), STEP);
      clock.add(nanos -> ticks.add("server " + nanos / STEP_NANOS), STEP.multipliedBy(2));
      clock.advance(STEP.multipliedBy(3));

      assertEquals(List.of("robot 1", "robot 2", "server 2", "robot 3"), ticks);
      assertEquals(EPOCH.plusMillis(60), clock.instant());
    }
  }

  @Test
  void timeIsTheSameForEverybodyWithinAStep() {
    try (VirtualClock clock = new VirtualClock(EPOCH, 1)) {
      List<Long> seen = new ArrayList<>();
      clock.add(nanos -> seen.add(clock.nanos()), STEP);
      clock.add(seen::add, STEP);
      clock.advance(STEP);

      assertEquals(List.of(STEP_NANOS, STEP_NANOS), seen);
    }
  }

  @Test
  void runningWorldWaitsForAParticipantThatIsNotReady() throws InterruptedException {
    AtomicBoolean ready = new AtomicBoolean(true);
    CountDownLatch waiting = new CountDownLatch(20);
    CountDownLatch onward = new CountDownLatch(1);
    List<Long> whileWaiting = new ArrayList<>();
    try (VirtualClock clock = new VirtualClock(EPOCH, 1_000)) {
      clock.add(
          new Participant() {
            @Override
            public void tick(long nanos) {
              if (nanos == 5 * STEP_NANOS) {
                ready.set(false);
              } else if (nanos > 5 * STEP_NANOS) {
                onward.countDown();
              }
            }

            @Override
            public boolean isReady(long nanos) {
              if (!ready.get()) {
                whileWaiting.add(nanos);
                waiting.countDown();
              }
              return ready.get();
            }
          },
          STEP);
      clock.start();
      assertTrue(waiting.await(10, TimeUnit.SECONDS));
      ready.set(true);
      assertTrue(onward.await(10, TimeUnit.SECONDS));
    }
    assertEquals(List.of(5 * STEP_NANOS), whileWaiting.stream().distinct().toList());
  }

  @Test
  void runningWorldDoesNotWaitForEverForWhoIsNeverReady() throws InterruptedException {
    CountDownLatch onward = new CountDownLatch(1_000);
    try (VirtualClock clock = new VirtualClock(EPOCH, 1_000, Duration.ofMillis(2))) {
      clock.add(
          new Participant() {
            @Override
            public void tick(long nanos) {
              if (clock.isReady()) {
                onward.countDown();
              }
            }

            @Override
            public boolean isReady(long nanos) {
              return false;
            }
          },
          STEP);
      clock.start();
      assertTrue(onward.await(20, TimeUnit.SECONDS));
    }
  }

  @Test
  void surpriseInOneParticipantIsItsOwn() {
    try (VirtualClock clock = new VirtualClock(EPOCH, 1)) {
      AtomicInteger failing = new AtomicInteger();
      AtomicInteger other = new AtomicInteger();
      clock.add(
          nanos -> {
            failing.incrementAndGet();
            throw new IllegalStateException("on purpose");
          },
          STEP);
      clock.add(nanos -> other.incrementAndGet(), STEP);
      clock.advance(STEP.multipliedBy(3));

      assertEquals(1, failing.get());
      assertEquals(3, other.get());
    }
  }

  @Test
  void removedParticipantHasNoTickAnyMore() {
    try (VirtualClock clock = new VirtualClock(EPOCH, 1)) {
      AtomicInteger ticks = new AtomicInteger();
      Participant participant = nanos -> ticks.incrementAndGet();
      clock.add(participant, STEP);
      clock.advance(STEP);
      clock.remove(participant);
      clock.advance(STEP);

      assertEquals(1, ticks.get());
    }
  }

  @Test
  void closedClockStands() throws InterruptedException {
    CountDownLatch running = new CountDownLatch(3);
    AtomicBoolean closed = new AtomicBoolean();
    AtomicBoolean late = new AtomicBoolean();
    VirtualClock clock = new VirtualClock(EPOCH, 1_000);
    clock.add(
        nanos -> {
          running.countDown();
          late.compareAndSet(false, closed.get());
        },
        STEP);
    clock.start();
    assertTrue(running.await(10, TimeUnit.SECONDS));
    clock.close();
    long then = clock.nanos();
    closed.set(true);

    assertEquals(then, clock.nanos());
    assertFalse(late.get());
  }

  @Test
  void senselessSpeedsAndPeriodsAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> new VirtualClock(EPOCH, 0));
    assertThrows(IllegalArgumentException.class, () -> new VirtualClock(EPOCH, Double.NaN));
    try (VirtualClock clock = new VirtualClock(EPOCH, 1)) {
      assertThrows(
          IllegalArgumentException.class, () -> clock.add(nanos -> {}, Duration.ofMillis(30)));
      assertThrows(IllegalArgumentException.class, () -> clock.add(nanos -> {}, Duration.ZERO));
    }
  }
}
