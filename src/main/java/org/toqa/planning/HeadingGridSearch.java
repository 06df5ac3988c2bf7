package org.toqa.planning;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** The searches of {@link HeadingAStar}, and the last grids as they see them. */
final class HeadingGridSearch implements GridSearch {
  private final GridLayouts layouts = new GridLayouts();
  private final JumpPoints jumpPoints;
  private final PieceOrder pieceOrder;
  private final OctileSearch octile;
  private final HeadingSearch heading;
  private final MoveSequence moves = new MoveSequence();

  /** What the octile distances are of that are known: of a layout as it was, to a goal. */
  private @Nullable GridLayout knownLayout;

  private int knownUpdates;
  private int knownGoal;

  HeadingGridSearch(OccupancyGrid grid) {
    GridLayout layout = layouts.layout(grid);
    jumpPoints = new JumpPoints(layout);
    pieceOrder = new PieceOrder(layout.graph(), jumpPoints);
    octile = new OctileSearch(layout.graph());
    heading = new HeadingSearch(layout.graph(), octile);
  }

  @Override
  public Optional<Path> path(OccupancyGrid grid, Cell start, Cell goal) {
    GridLayout layout = layouts.layout(grid);
    int from = grid.index(start);
    int to = grid.index(goal);
    if (layout.graph().isDirected()) { // jump points are for moves that lead back too
      return searchHeadings(layout, from, to)
          ? Optional.of(Path.of(start, moves, true))
          : Optional.empty();
    }
    if (!jumpPoints.search(layout, from, to)) {
      return Optional.empty();
    }
    if (!pieceOrder.order(layout.graph(), moves)) {
      searchHeadings(layout, from, to);
    }
    return Optional.of(Path.of(start, moves, true));
  }

  /** Whether there is a path. */
  private boolean searchHeadings(GridLayout layout, int from, int to) {
    boolean isKnown =
        knownLayout == layout
            && knownUpdates == layout.updates()
            && knownGoal == to
            && octile.isKnown(from);
    knownLayout = null; // until this has come to its end
    MoveGraph graph = layout.graph();
    if (!isKnown) {
      octile.begin(graph, to, from);
    }
    int shortest = octile.distance(from);
    boolean isFound =
        shortest != OctileSearch.UNREACHABLE
            && (heading.search(graph, from, to, shortest, false, moves)
                || heading.search(graph, from, to, shortest, true, moves));
    knownLayout = layout;
    knownUpdates = layout.updates();
    knownGoal = to;
    return isFound;
  }

  @Override
  public long expandedCount() {
    return jumpPoints.expandedCount() + octile.expandedCount() + heading.expandedCount();
  }
}
