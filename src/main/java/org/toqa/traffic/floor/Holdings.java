package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import org.toqa.grid.OccupancyGrid;

/**
 * Who holds which cell of the floor now. Taken anew from the movers with {@link #take}; a cell held
 * by two, as under robots that were put side by side, counts as held by each for the other.
 */
final class Holdings {
  private static final int NOBODY = 0;
  private static final int SEVERAL = -1;

  /** By cell: a mover's number, nobody or several. */
  private final int[] holder;

  private final Collection<Mover> movers;

  Holdings(OccupancyGrid grid, Collection<Mover> movers) {
    this.holder = new int[grid.width() * grid.height()];
    this.movers = movers;
  }

  void take() {
    Arrays.fill(holder, NOBODY);
    movers.forEach(m -> m.forEachHeld(cells -> add(m, cells)));
  }

  void add(Mover mover, CellSet cells) {
    cells.forEach(
        cell -> {
          int before = holder[cell];
          holder[cell] = before == NOBODY || before == mover.number ? mover.number : SEVERAL;
        });
  }

  /** The other movers that hold some of the cells. */
  List<Mover> others(Mover mover, CellSet cells) {
    List<Mover> others = new ArrayList<>();
    cells.forEach(
        cell -> {
          int number = holder[cell];
          if (number == SEVERAL) {
            movers.stream().filter(m -> m.held().get(cell)).forEach(m -> addTo(others, mover, m));
          } else if (number != NOBODY && number != mover.number) {
            movers.stream().filter(m -> m.number == number).forEach(m -> addTo(others, mover, m));
          }
        });
    return others;
  }

  private static void addTo(List<Mover> others, Mover mover, Mover found) {
    if (found != mover && !others.contains(found)) {
      others.add(found);
    }
  }
}
