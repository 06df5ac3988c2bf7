package org.toqa.allocation;

import java.util.HashSet;
import java.util.Set;

/**
 * What is settled of the teams of a round, by their numbers: those that are chosen get all their
 * robots, those that are dropped none, and of the others it is open.
 */
record TeamChoices(Set<Integer> chosen, Set<Integer> dropped, Set<Exclusion> exclusions) {
  static final TeamChoices NONE = new TeamChoices(Set.of(), Set.of(), Set.of());

  /** A robot, by its number, that is not to be in a team. */
  record Exclusion(int team, int robot) {}

  TeamChoices choosing(int team) {
    return new TeamChoices(with(chosen, team), dropped, exclusions);
  }

  TeamChoices dropping(int team) {
    return new TeamChoices(chosen, with(dropped, team), exclusions);
  }

  TeamChoices excluding(int team, int robot) {
    return new TeamChoices(chosen, dropped, with(exclusions, new Exclusion(team, robot)));
  }

  boolean isOpen(int team) {
    return !chosen.contains(team) && !dropped.contains(team);
  }

  private static <T> Set<T> with(Set<T> some, T another) {
    Set<T> more = new HashSet<>(some);
    more.add(another);
    return Set.copyOf(more);
  }
}
