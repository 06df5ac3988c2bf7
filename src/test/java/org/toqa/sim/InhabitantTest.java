package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class InhabitantTest {
  private static final long STEP = VirtualClock.STEP.toNanos();
  private static final long APART = Inhabitant.RECOVERY.toNanos() + STEP;

  private boolean isReady;
  private long nanos;
  private final Inhabitant inhabitant =
      new Inhabitant(
          new Participant() {
            @Override
            public void tick(long now) {}

            @Override
            public boolean isReady(long now) {
              return isReady;
            }
          },
          STEP);

  private boolean isAwaited() {
    return inhabitant.isAwaited(nanos);
  }

  private void goOn(boolean isForced) {
    inhabitant.goOn(nanos, isForced);
    nanos += STEP;
  }

  private void holdUp(int times) {
    for (int i = 0; i < times; i++) {
      goOn(true);
    }
  }

  @Test
  void whoHoldsTheWorldUpTimeAfterTimeIsNotWaitedForUntilReady() {
    assertTrue(isAwaited());
    holdUp(Inhabitant.MOST_HOLDS - 1);
    assertTrue(isAwaited());
    holdUp(1);
    assertFalse(isAwaited());
    goOn(false);
    assertFalse(isAwaited());

    isReady = true;
    goOn(false);
    isReady = false;
    assertTrue(isAwaited());
  }

  @Test
  void whoHasBeenGivenUpHasLessPatienceLeftAtFirst() {
    holdUp(Inhabitant.MOST_HOLDS);
    isReady = true;
    goOn(false);
    isReady = false;
    holdUp(1);
    assertFalse(isAwaited());

    nanos += APART;
    goOn(false); // all that time it was not ready
    isReady = true;
    goOn(false);
    isReady = false;
    holdUp(1);
    assertFalse(isAwaited());

    isReady = true;
    goOn(false);
    nanos += APART;
    isReady = false;
    holdUp(Inhabitant.MOST_HOLDS - 1);
    assertTrue(isAwaited());
  }

  @Test
  void holdsThatAreFarApartDoNotCountTogether() {
    for (int i = 0; i < 10 * Inhabitant.MOST_HOLDS; i++) {
      holdUp(1);
      nanos += APART;
    }
    assertTrue(isAwaited());
  }

  @Test
  void whoIsReadyDoesNotAnswerForOthers() {
    isReady = true;
    holdUp(2 * Inhabitant.MOST_HOLDS);
    isReady = false;
    assertTrue(isAwaited());
  }
}
