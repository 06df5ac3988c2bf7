package org.toqa.app.bench;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.NearestFreeRobot;
import org.toqa.allocation.Policy;
import org.toqa.app.command.WordConverter;

/** {@code --policy}: which allocators are measured. */
enum PolicyChoice {
  ALL,
  NEAREST,
  ZONES,
  CONTRACT_NET,
  OPTIMAL;

  /** By name, in the order in which they are measured. */
  Map<String, Allocator> allocators() {
    Map<String, Allocator> allocators = new LinkedHashMap<>();
    if (this == ALL || this == NEAREST) {
      allocators.put("nearest", new NearestFreeRobot());
    }
    Arrays.stream(Policy.values())
        .filter(policy -> this == ALL || name().equals(policy.name()))
        .forEach(policy -> allocators.put(policy.word(), policy.allocator()));
    return allocators;
  }

  /** Reads what a user types. */
  static final class Converter extends WordConverter<PolicyChoice> {
    Converter() {
      super(values());
    }
  }
}
