package org.toqa.formation.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class LoopMemoryTest {
  private static final double SQUARE = 10;

  /** Drives a square of 40 m on a side in steps of 1 m, a number of times. */
  private static LoopMemory afterRounds(int rounds) {
    LoopMemory memory = LoopMemory.empty(SQUARE);
    Vec2 at = new Vec2(5, 5);
    for (int side = 0; side < 4 * rounds; side++) {
      double direction = side % 4 * Math.PI / 2;
      for (int step = 0; step < 40; step++) {
        at = at.plus(new Vec2(1, 0).rotated(direction));
        memory = memory.next(at, direction, 1);
      }
    }
    return memory;
  }

  @Test
  void whoWasNeverThereBeforeTakesNoDetour() {
    assertFalse(afterRounds(1).isDetour());
  }

  @Test
  void eachRoundOfALoopDoublesTheDetour() {
    double second = afterRounds(2).detour();
    double third = afterRounds(3).detour();

    assertTrue(second > 0);
    // 20 m after one loop and 40 m after two, less what was driven since the last square
    assertEquals(2 * SQUARE, third - second, 1e-9);
  }

  @Test
  void whoSwaysOnTheSpotIsInNoLoop() {
    LoopMemory memory = LoopMemory.empty(SQUARE);
    for (int i = 0; i < 200; i++) {
      memory = memory.next(new Vec2(5, 5), i % 2 == 0 ? 0 : 1, 0.5);
    }

    assertFalse(memory.isDetour());
  }
}
