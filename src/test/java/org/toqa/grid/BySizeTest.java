package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.junit.jupiter.api.Test;

class BySizeTest {
  private final BySize<Object> values = new BySize<>();
  private int computed;

  @Test
  void aRobotThatSaysEverOtherSizesTakesNoMemory() {
    Object usual = get(0.255);
    for (int i = 1; i <= 10 * BySize.MAX_SIZES; i++) {
      get(0.255 + i / 1e6);
      assertSame(usual, get(0.255), "what others need is kept");
    }

    assertEquals(BySize.MAX_SIZES, values.count());
    assertEquals(1 + 10 * BySize.MAX_SIZES, computed);
  }

  private Object get(double size) {
    return values.get(
        size,
        _ -> {
          computed++;
          return new Object();
        });
  }
}
