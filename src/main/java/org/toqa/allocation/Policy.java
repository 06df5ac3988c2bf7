package org.toqa.allocation;

import java.util.Locale;

/** The allocators by the names that people give them. */
public enum Policy {
  ZONES,
  CONTRACT_NET,
  OPTIMAL;

  public Allocator allocator() {
    return switch (this) {
      case ZONES -> new TeamAllocator(new ZoneAllocator(), ZoneTeams::new);
      case CONTRACT_NET -> new TeamAllocator(new ContractNet(), _ -> new NearestTeams());
      case OPTIMAL -> new TeamAllocator(new OptimalAllocator(), _ -> new NearestTeams());
    };
  }

  /** As it is written, such as {@code contract-net}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
