package org.toqa.lab.record;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * A run that somebody wants.
 *
 * @param experiment by its name
 * @param values of parameters that were set, by name
 */
public record LabOrder(String experiment, long seed, int runs, Map<String, Double> values) {
  public LabOrder {
    values = Collections.unmodifiableMap(new TreeMap<>(values));
  }
}
