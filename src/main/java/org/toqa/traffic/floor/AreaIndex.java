package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/**
 * Areas that others have or will need, found by place: a question costs as much as there is near to
 * what it is about. Nobody changes it.
 */
final class AreaIndex {
  private final List<SweptArea> areas;
  private final Map<Square, List<SweptArea>> bySquare = new HashMap<>();

  AreaIndex(List<SweptArea> areas) {
    this.areas = List.copyOf(areas);
    for (SweptArea area : areas) {
      Square.forEach(
          area, 0, square -> bySquare.computeIfAbsent(square, s -> new ArrayList<>()).add(area));
    }
  }

  List<SweptArea> areas() {
    return areas;
  }

  /** Whether a robot that covers an area keeps off all of them. */
  boolean isKept(SweptArea area) {
    return allNear(area, other -> Clearance.isKept(area, other));
  }

  /**
   * Whether a robot can go over an area, as far as these are concerned.
   *
   * @param standing what it covers where it sets out
   */
  boolean isKept(SweptArea standing, SweptArea area) {
    return allNear(area, other -> Clearance.isKept(standing, area, other));
  }

  private boolean allNear(SweptArea area, Predicate<SweptArea> isRight) {
    boolean[] isAll = {true};
    if (!areas.isEmpty()) {
      Square.forEach(
          area,
          Clearance.BETWEEN_ROBOTS,
          square ->
              isAll[0] =
                  isAll[0] && bySquare.getOrDefault(square, List.of()).stream().allMatch(isRight));
    }
    return isAll[0];
  }
}
