package org.toqa.lab.cmct;

import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.cmct.CmctWalk;
import org.toqa.planning.cmct.LatticeAStar;
import org.toqa.planning.cmct.LatticeResult;
import org.toqa.planning.cmct.LatticeResult.Effort;
import org.toqa.planning.cmct.StepLattice;

/** What plans in the comparison, and by which moves. */
enum PlannerMethod {
  CMCT("CMCT-PP", true, true),
  A_STAR("A*, same moves", false, true),
  CMCT_CELLS("CMCT-PP, cell to cell", true, false),
  A_STAR_CELLS("A*, cell to cell", false, false);

  private final String title;
  private final boolean isGreedy;
  private final boolean isOfTenths;

  PlannerMethod(String title, boolean isGreedy, boolean isOfTenths) {
    this.title = title;
    this.isGreedy = isGreedy;
    this.isOfTenths = isOfTenths;
  }

  /**
   * A path.
   *
   * @param points metres
   * @param length metres
   */
  record Planned(List<Vec2> points, double length, Effort effort) {}

  String title() {
    return title;
  }

  /**
   * @throws IllegalStateException it finds no path, where there is one in each scene
   */
  Planned plan(OccupancyGrid grid, Cell start, Cell goal) {
    StepLattice lattice =
        isOfTenths ? StepLattice.ofTenths(grid, start, goal) : StepLattice.ofCells(grid);
    Cell from = lattice.pointOf(start);
    Cell to = lattice.pointOf(goal);
    LatticeResult result =
        isGreedy ? CmctWalk.plan(lattice, from, to) : LatticeAStar.plan(lattice, from, to);
    if (result instanceof LatticeResult.Found found) {
      return new Planned(
          found.points().stream().map(lattice::position).toList(),
          lattice.length(found.points()),
          found.effort());
    }
    throw new IllegalStateException(title + " found no path from " + start + " to " + goal + ".");
  }
}
