package org.toqa.allocation;

import java.util.Locale;

/** The allocators by the names that people give them. */
public enum Policy {
  ZONES,
  CONTRACT_NET,
  OPTIMAL;

  public Allocator allocator() {
    return new TeamAllocator(
        switch (this) {
          case ZONES -> new ZoneAllocator();
          case CONTRACT_NET -> new ContractNet();
          case OPTIMAL -> new OptimalAllocator();
        });
  }

  /** As it is written, such as {@code contract-net}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
