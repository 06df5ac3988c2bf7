package org.toqa.agent.formation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.toqa.agent.chassis.Chassis;

class BroadcastTimerTest {

  private static final long TICK = Chassis.TICK.toNanos();
  private static final int TICKS = 1_000;

  private final SplittableRandom chance = new SplittableRandom(20261122);

  /** The first tick is as late as the others, so the due times lie anywhere between ticks. */
  @Test
  void everyTenthTickIsTakenHoweverLateTicksAre() {
    for (int run = 0; run < 100; run++) {
      BroadcastTimer pace = new BroadcastTimer(late());
      assertEquals(
          LongStream.iterate(0, t -> t < TICKS, t -> t + 10).boxed().toList(),
          taken(pace, 0, false));
    }
  }

  @Test
  void whileItBrakesEveryTickIsTaken() {
    BroadcastTimer pace = new BroadcastTimer(late());
    pace.fireIfDue(false, late());

    assertEquals(LongStream.range(1, TICKS).boxed().toList(), taken(pace, 1, true));
  }

  @Test
  void whatWasMissedIsNotMadeUpFor() {
    BroadcastTimer pace = new BroadcastTimer(0);
    pace.fireIfDue(false, 0);

    assertEquals(true, pace.fireIfDue(false, 100 * TICK));
    assertEquals(false, pace.fireIfDue(false, 101 * TICK));
    assertEquals(true, pace.fireIfDue(false, 110 * TICK));
  }

  private List<Long> taken(BroadcastTimer pace, long from, boolean braking) {
    return LongStream.range(from, TICKS)
        .filter(tick -> pace.fireIfDue(braking, tick * TICK + late()))
        .boxed()
        .toList();
  }

  /** Up to 4 ms. */
  private long late() {
    return chance.nextLong(4_000_000);
  }
}
