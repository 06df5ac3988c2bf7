package org.toqa.allocation;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;

/** A contract that holds when all robots of it have confirmed it: an award, or a trade. */
final class Deal {
  private final Decision.@Nullable Assigned award;
  private final @Nullable Trade trade;
  private final Set<String> awaited;
  private boolean isVoid;

  private Deal(Decision.@Nullable Assigned award, @Nullable Trade trade, Set<String> robots) {
    this.award = award;
    this.trade = trade;
    this.awaited = new TreeSet<>(robots);
  }

  static Deal of(Decision.Assigned award) {
    return new Deal(award, null, Set.copyOf(award.robots()));
  }

  static Deal of(Trade trade) {
    return new Deal(null, trade, trade.robots());
  }

  /** Null: it is an award. */
  @Nullable Trade trade() {
    return trade;
  }

  /** Of one that is no trade. */
  Decision.Assigned award() {
    return requireNonNull(award);
  }

  List<Long> tasks() {
    return trade == null
        ? List.of(award().task())
        : trade.legs().stream().map(Trade.Leg::task).toList();
  }

  /** The robots that have not answered. */
  Set<String> awaited() {
    return Set.copyOf(awaited);
  }

  /** Whether the robot's answer was awaited. */
  boolean takeAnswer(String robot) {
    return awaited.remove(robot);
  }

  void annul() {
    isVoid = true;
  }

  boolean isVoid() {
    return isVoid;
  }

  /** Whether it is still to be seen whether it holds. */
  boolean isOpen() {
    return !isVoid && !awaited.isEmpty();
  }
}
