package org.toqa.allocation;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** How many robots it takes to carry a load in even shares. */
public final class TeamSize {
  private TeamSize() {}

  /** The least number; empty where all of them together do not. */
  public static Optional<Integer> smallest(double load, List<Candidate> robots) {
    return IntStream.rangeClosed(1, robots.size())
        .filter(n -> robots.stream().filter(r -> r.maxLoad() * n >= load).count() >= n)
        .boxed()
        .findFirst();
  }
}
