package org.toqa.allocation;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Tasks that change hands at once: one is sold, or several along a chain of robots or round a ring.
 *
 * @param legs a chain from its first seller on; of a ring, from anywhere
 * @param saved joules, by all of them together
 */
record Trade(List<Leg> legs, double saved) {

  /**
   * @param price joules that the seller pays the buyer
   */
  record Leg(long task, String seller, String buyer, double price) {}

  Trade {
    legs = List.copyOf(legs);
  }

  Set<String> robots() {
    return legs.stream()
        .flatMap(leg -> Stream.of(leg.seller(), leg.buyer()))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Joules that the robot is paid, less what it pays. */
  double income(String robot) {
    return legs.stream()
        .mapToDouble(
            leg ->
                (leg.buyer().equals(robot) ? leg.price() : 0)
                    - (leg.seller().equals(robot) ? leg.price() : 0))
        .sum();
  }
}
