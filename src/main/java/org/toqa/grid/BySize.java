package org.toqa.grid;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.DoubleFunction;

/**
 * What is computed once for robots of a size. Robots say their size themselves: of very many sizes
 * the last ones asked for are kept. Any thread may ask.
 */
public final class BySize<V> {
  /** A fleet has a few; one robot may say another one at each connection. */
  static final int MAX_SIZES = 64;

  private final Map<Double, V> values = new LinkedHashMap<>(16, 0.75f, true);

  /**
   * @param size metres
   */
  public synchronized V get(double size, DoubleFunction<V> compute) {
    V known = values.get(size);
    if (known != null) {
      return known;
    }
    V value = compute.apply(size);
    values.put(size, value);
    if (values.size() > MAX_SIZES) {
      values.remove(values.keySet().iterator().next());
    }
    return value;
  }

  /** What was computed counts no more. */
  public synchronized void clear() {
    values.clear();
  }

  /** How many sizes are kept. */
  synchronized int count() {
    return values.size();
  }
}
