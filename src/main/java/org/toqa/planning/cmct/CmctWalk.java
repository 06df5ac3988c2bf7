package org.toqa.planning.cmct;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.planning.cmct.LatticeResult.Effort;
import org.toqa.planning.cmct.LatticeResult.Found;
import org.toqa.planning.cmct.LatticeResult.NotFound;
import org.toqa.planning.cmct.LatticeResult.Reason;

/**
 * CMCT-PP: a greedy walk that keeps no list of points, but the path itself.
 *
 * <ol>
 *   <li>From the present point it tries one step along x (path 1), the diagonal (path 2) and one
 *       step along y (path 3), each toward the goal, and takes the free one from which the goal is
 *       nearest; of two equal ones the first. The printed rule takes the one from which it is
 *       farthest, which does not arrive.
 *   <li>Where none is free, the obstacle that is in the way is gone round "the shorter way". What
 *       that is the paper leaves open; here: the walk goes along the obstacle's border by straight
 *       steps, once with it on the right hand and once on the left, each until a point that is
 *       nearer to the goal than where it was stopped, and from which a step toward the goal is
 *       free. Two steps round a free corner become a diagonal one, and the shorter of both is the
 *       path; of equal ones that with the obstacle on the right.
 *   <li>Where a whole round has no such point, the path leads to the nearest point of the border
 *       and goes on from there round the next obstacle. If that is not nearer than where it was
 *       stopped, there is no path.
 * </ol>
 *
 * <p>It ends: each step, and each way round, ends nearer to the goal than it began, and a round is
 * no longer than four times the points. It finds a path wherever there is one, as the bug
 * algorithms of Lumelsky and Stepanov (1987) do: of the points on the straight line to the goal
 * that are on the obstacle's border, one is nearer than where it was stopped. Where moves are
 * allowed in one direction only, a border need not lead round, and the answer may be {@link
 * Reason#GAVE_UP}.
 */
public final class CmctWalk {
  private final StepLattice lattice;
  private final Cell goal;
  private final List<Cell> points = new ArrayList<>();
  private long visited;

  /**
   * A way along the border of an obstacle.
   *
   * @param leaves whether a step toward the goal is free at its end
   * @param length metres
   */
  private record Round(List<Cell> points, boolean leaves, double length) {}

  private CmctWalk(StepLattice lattice, Cell start, Cell goal) {
    this.lattice = lattice;
    this.goal = goal;
    points.add(start);
  }

  /** Plans from one point of a lattice to another. */
  public static LatticeResult plan(StepLattice lattice, Cell start, Cell goal) {
    if (!lattice.isFree(start.column(), start.row())) {
      return new NotFound(Reason.START_BLOCKED, new Effort(0, 0));
    }
    if (!lattice.isFree(goal.column(), goal.row())) {
      return new NotFound(Reason.GOAL_BLOCKED, new Effort(0, 0));
    }
    return new CmctWalk(lattice, start, goal).walk();
  }

  private LatticeResult walk() {
    while (!points.getLast().equals(goal)) {
      Cell here = points.getLast();
      Heading step = bestStep(here);
      if (step != null) {
        visited++;
        points.add(after(here, step));
      } else if (!goRound(here)) {
        Reason reason = lattice.isDirected() ? Reason.GAVE_UP : Reason.NO_PATH;
        return new NotFound(reason, new Effort(visited, 0));
      }
    }
    return new Found(points, new Effort(visited, 0));
  }

  /** The free one of the three steps from which the goal is nearest; none where none is free. */
  private @Nullable Heading bestStep(Cell here) {
    Heading best = null;
    long nearest = Long.MAX_VALUE;
    for (Heading step : stepsToward(here)) {
      Cell next = after(here, step);
      long left = lattice.squareBetween(next.column(), next.row(), goal);
      if (left < nearest && lattice.allows(here.column(), here.row(), step)) {
        nearest = left;
        best = step;
      }
    }
    return best;
  }

  /** Paths 1, 2 and 3, but for those that would not bring the goal nearer. */
  private List<Heading> stepsToward(Cell here) {
    int x = Integer.signum(goal.column() - here.column());
    int y = Integer.signum(goal.row() - here.row());
    if (x == 0 || y == 0) {
      return List.of(Heading.of(x, y));
    }
    return List.of(Heading.of(x, 0), Heading.of(x, y), Heading.of(0, y));
  }

  /** Adds the shorter way round what is in the way; whether there is one. */
  private boolean goRound(Cell from) {
    Round left = round(from, true);
    Round right = round(from, false);
    Round shorter;
    if (left == null || right == null) {
      shorter = left == null ? right : left;
    } else if (left.leaves() != right.leaves()) { // one leaves the border, the other does not
      shorter = left.leaves() ? left : right;
    } else {
      shorter = right.length() <= left.length() ? right : left;
    }
    if (shorter == null) {
      return false;
    }
    points.addAll(shorter.points().subList(1, shorter.points().size()));
    return true;
  }

  private @Nullable Round round(Cell from, boolean turnsLeft) {
    int side = turnsLeft ? 2 : -2; // eighths of a turn away from the obstacle
    Heading blocked = stepsToward(from).getFirst();
    long limit = lattice.squareBetween(from.column(), from.row(), goal);
    List<Cell> border = new ArrayList<>(List.of(from));
    int nearest = 0;
    long least = limit;
    Heading heading = blocked.turned(side);
    Heading first = null;
    Cell here = from;
    int most = 4 * lattice.width() * lattice.height();
    for (int i = 0; i < most; i++) {
      Heading next = alongBorder(here, heading, side);
      if (next == null || (here.equals(from) && next == first)) {
        break;
      }
      first = first == null ? next : first;
      heading = next;
      here = after(here, next);
      visited++;
      border.add(here);
      long left = lattice.squareBetween(here.column(), here.row(), goal);
      if (left < limit && (here.equals(goal) || bestStep(here) != null)) {
        return finished(border, true);
      }
      if (left < least) {
        least = left;
        nearest = border.size() - 1;
      }
    }
    return nearest == 0 ? null : finished(border.subList(0, nearest + 1), false);
  }

  /** The first straight step that is free, from that toward the obstacle on. */
  private @Nullable Heading alongBorder(Cell here, Heading heading, int side) {
    for (int turn = -1; turn <= 2; turn++) {
      Heading next = heading.turned(turn * side);
      if (lattice.allows(here.column(), here.row(), next)) {
        return next;
      }
    }
    return null;
  }

  /** With each two steps round a free corner as one diagonal step. */
  private Round finished(List<Cell> border, boolean leaves) {
    List<Cell> path = new ArrayList<>(List.of(border.getFirst()));
    int i = 0;
    while (i < border.size() - 1) {
      Cell here = border.get(i);
      i += i + 2 < border.size() && isFreeCorner(here, border.get(i + 2)) ? 2 : 1;
      path.add(border.get(i));
    }
    return new Round(path, leaves, lattice.length(path));
  }

  private boolean isFreeCorner(Cell here, Cell next) {
    int x = next.column() - here.column();
    int y = next.row() - here.row();
    return Math.abs(x) == 1
        && Math.abs(y) == 1
        && lattice.allows(here.column(), here.row(), Heading.of(x, y));
  }

  private static Cell after(Cell here, Heading step) {
    return new Cell(here.column() + step.dColumn(), here.row() + step.dRow());
  }
}
