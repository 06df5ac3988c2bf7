package org.toqa.allocation;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The allocators by the names that people give them. */
public enum Policy {
  ZONES,
  CONTRACT_NET,
  OPTIMAL;

  public AllocationMethod method() {
    return switch (this) {
      case ZONES ->
          new AllocationMethod.Computed(new TeamAllocator(new ZoneAllocator(), ZoneTeams::new));
      case CONTRACT_NET -> new AllocationMethod.Negotiated();
      case OPTIMAL -> new AllocationMethod.Computed(new OptimalAllocator());
    };
  }

  /** The one that is written so; empty: there is none. */
  public static Optional<Policy> ofWord(String word) {
    return Arrays.stream(values()).filter(policy -> policy.word().equals(word)).findFirst();
  }

  /** As it is written, such as {@code contract-net}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
