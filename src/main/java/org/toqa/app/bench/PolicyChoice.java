package org.toqa.app.bench;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import org.toqa.allocation.AllocationMethod;
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
  Map<String, AllocationMethod> methods() {
    Map<String, AllocationMethod> methods = new LinkedHashMap<>();
    if (this == ALL || this == NEAREST) {
      methods.put("nearest", new AllocationMethod.Computed(new NearestFreeRobot()));
    }
    Arrays.stream(Policy.values())
        .filter(policy -> this == ALL || name().equals(policy.name()))
        .forEach(policy -> methods.put(policy.word(), policy.method()));
    return methods;
  }

  /** Reads what a user types. */
  static final class Converter extends WordConverter<PolicyChoice> {
    Converter() {
      super(values());
    }
  }
}
