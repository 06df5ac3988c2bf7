package org.toqa.planning;

import java.util.function.LongConsumer;

/**
 * Shortest paths with eight moves, whatever the corners: jump point search without corner cutting
 * (Harabor and Grastien, "Online graph pruning for pathfinding on grid maps", AAAI 2011; "Improving
 * jump point search", ICAPS 2014).
 *
 * <p>Of all paths of equal length it looks only at those that go diagonally first and straight
 * then. Such a path has a reason to turn only beside the end of an obstacle: between these jump
 * points nothing is put on the open list. Straights are looked through 64 cells at a time, and
 * diagonals are no nodes of their own: a node's successors are the jump points beside them.
 *
 * <p>For benchmarks; and what {@link HeadingAStar} asks first.
 */
public final class JumpPointSearch extends GridPlanner {

  public JumpPointSearch() {
    this(expanded -> {});
  }

  /**
   * @param expandedListener is told after each search how many jump points it has expanded
   */
  public JumpPointSearch(LongConsumer expandedListener) {
    super(JumpPointGridSearch::new, expandedListener);
  }
}
