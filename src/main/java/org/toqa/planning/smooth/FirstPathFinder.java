package org.toqa.planning.smooth;

import org.jspecify.annotations.Nullable;

/**
 * Finds some path: by jump points on the space's lattice; where that has none, asks once whether
 * there can be a path at all, and searches lattices from a coarse one to ever finer ones.
 */
final class FirstPathFinder {
  private static final double FINEST = 1.0 / 64;

  private final DiscSpace space;
  private final WayPoints ends;
  private final PlanningBudget budget;
  private double spacing;
  private boolean isParted;
  private boolean isAsked;

  FirstPathFinder(DiscSpace space, WayPoints ends, PlanningBudget budget) {
    this.space = space;
    this.ends = ends;
    this.budget = budget;
    this.spacing = LatticeSearch.firstSpacing(space);
  }

  /** Whether it is known that there is no path. */
  boolean isParted() {
    return isParted;
  }

  /** Whether there is still a lattice to search. */
  boolean canGoOn() {
    return !isParted && spacing >= FINEST;
  }

  /** Searches the next lattice; null where it has no path. */
  @Nullable WayPoints search() {
    if (!isAsked) {
      isAsked = true;
      WayPoints path = space.lattice().path(ends, budget::isTimeOver);
      isParted = path == null && new Connectivity(space, ends).isParted();
      return path;
    }
    LatticeSearch lattice = new LatticeSearch(space, ends, spacing, budget::isTimeOver);
    WayPoints path = lattice.search();
    if (path == null && !lattice.wasStopped()) {
      spacing /= 2;
    }
    return path;
  }
}
