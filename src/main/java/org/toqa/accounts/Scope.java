package org.toqa.accounts;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** What a token may do of what its user may. */
public enum Scope {
  /** See tasks, robots, maps, history and statistics, also live. */
  READ,
  /** Add and change tasks and schedules. */
  TASKS,
  /** Everything else: robots, floors, the pause, users. */
  MANAGE,
  /** Read what is measured. */
  METRICS;

  /** What a login may. */
  public static final Set<Scope> ALL = Set.copyOf(EnumSet.allOf(Scope.class));

  /** As people and programs write it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  public static Optional<Scope> ofWord(String word) {
    return Arrays.stream(values()).filter(scope -> scope.word().equals(word)).findFirst();
  }
}
