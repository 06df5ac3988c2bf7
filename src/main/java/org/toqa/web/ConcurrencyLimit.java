package org.toqa.web;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** How many of something each may have at once: users, addresses. Any thread may call it. */
public final class ConcurrencyLimit {
  private final int max;
  private final Map<String, Integer> counts = new ConcurrentHashMap<>();

  /**
   * @param max of each, at least 1
   */
  public ConcurrencyLimit(int max) {
    this.max = max;
  }

  /** How many each may have. */
  public int max() {
    return max;
  }

  /**
   * @return false when he has as many as he may; else he has one more, until it is released
   */
  public boolean tryAcquire(String holder) {
    boolean[] isAcquired = {false};
    counts.compute(
        holder,
        (_, count) -> {
          int held = count == null ? 0 : count;
          isAcquired[0] = held < max;
          return isAcquired[0] ? Integer.valueOf(held + 1) : count;
        });
    return isAcquired[0];
  }

  /** He has one fewer than before. */
  public void release(String holder) {
    counts.computeIfPresent(holder, (_, count) -> count > 1 ? count - 1 : null);
  }
}
