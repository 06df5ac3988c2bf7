package org.toqa.fleet.manager;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.fleet.floor.PlaceCheck;
import org.toqa.grid.Cell;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Where the smallest robot gets by moves of the grid: the part of a floor in which most of its
 * places can be driven to from each other (without places, the largest part), and what can be
 * driven to from there, and from where it can be driven to.
 *
 * @param connected the part whatever the directions of areas, cells by {@link OccupancyGrid#index}
 * @param reached cells of it: a robot of that part gets there
 * @param left a robot gets from there to that part
 */
record Reach(OccupancyGrid grid, BitSet connected, BitSet reached, BitSet left) {
  /** East, north, west and south, as {@link OccupancyGrid#forbiddenFrom} counts them. */
  private static final int[] DIRECTIONS = {0, 2, 4, 6};

  /** So many parts are looked at where areas have directions. */
  private static final int MOST_PARTS = 16;

  /** Which moves a flood takes. */
  private enum Moves {
    ALL,
    ALLOWED,
    ALLOWED_BACKWARD;

    /** Bits by direction. */
    int forbidden(OccupancyGrid grid, int cell) {
      return switch (this) {
        case ALL -> 0;
        case ALLOWED -> grid.forbiddenFrom(cell);
        case ALLOWED_BACKWARD -> grid.forbiddenInto(cell);
      };
    }
  }

  static Reach of(OccupancyGrid grid, List<Place> places) {
    OccupancyGrid room = Inflation.inflate(grid, PlaceCheck.SMALLEST_RADIUS);
    BitSet connected = connected(room, places);
    return grid.rules().isDirected()
        ? underRules(room, connected, places)
        : new Reach(grid, connected, connected, connected);
  }

  /**
   * The connected part, whatever the directions of areas, that has the most places; of several the
   * largest one.
   */
  private static BitSet connected(OccupancyGrid room, List<Place> places) {
    Parts parts = Parts.of(room);
    int[] found = new int[parts.cells().length];
    for (Place place : places) {
      parts.around(room, place).forEach(part -> found[part]++);
    }
    int best = 0; // what is in no part
    for (int part = 1; part < found.length; part++) {
      boolean hasAsMany = best == 0 || found[part] == found[best];
      if (hasAsMany ? parts.cells()[part] > parts.cells()[best] : found[part] > found[best]) {
        best = part;
      }
    }
    return parts.members(best);
  }

  /**
   * The connected parts of a floor, found in one look at each cell: there may be as many as cells.
   *
   * @param labels by cell the number of its part, from 1; 0: none
   * @param cells by part, how many; none of 0
   */
  private record Parts(int[] labels, int[] cells) {
    static Parts of(OccupancyGrid room) {
      int size = room.width() * room.height();
      BitSet unseen = new BitSet(size);
      unseen.set(0, size);
      unseen.andNot(room.occupied());
      int[] labels = new int[size];
      int[] cells = new int[64];
      int last = 0;
      for (int start = unseen.nextSetBit(0); start >= 0; start = unseen.nextSetBit(start)) {
        int part = ++last;
        if (part == cells.length) {
          cells = Arrays.copyOf(cells, 2 * part);
        }
        int[] counts = cells;
        flood(
            room,
            unseen,
            start,
            Moves.ALL,
            cell -> {
              labels[cell] = part;
              counts[part]++;
            });
      }
      return new Parts(labels, Arrays.copyOf(cells, last + 1));
    }

    /** Those in which a place is, or beside which. */
    IntStream around(OccupancyGrid room, Place place) {
      return room.cellsAround(place.position(), 1).stream()
          .mapToInt(cell -> labels[room.index(cell)])
          .filter(part -> part > 0)
          .distinct();
    }

    BitSet members(int part) {
      BitSet members = new BitSet();
      for (int cell = 0; part > 0 && cell < labels.length; cell++) {
        if (labels[cell] == part) {
          members.set(cell);
        }
      }
      return members;
    }
  }

  /** Of a connected part, from and to the cells that are driven to from each other. */
  private static Reach underRules(OccupancyGrid room, BitSet connected, List<Place> places) {
    Reach best = new Reach(room, connected, connected, connected);
    int most = 0;
    List<Place> rest = placesIn(room, connected, connected, places);
    for (int i = 0; i < MOST_PARTS && rest.size() > most; i++) {
      int start = cellOf(room, connected, connected, rest.getFirst()).orElseThrow();
      BitSet reached = flood(room, (BitSet) connected.clone(), start, Moves.ALLOWED);
      BitSet left = flood(room, (BitSet) connected.clone(), start, Moves.ALLOWED_BACKWARD);
      BitSet both = (BitSet) reached.clone();
      both.and(left);
      List<Place> found = placesIn(room, connected, both, rest);
      if (found.size() > most) {
        best = new Reach(room, connected, reached, left);
        most = found.size();
      }
      rest.removeAll(found);
    }
    return best;
  }

  private static List<Place> placesIn(
      OccupancyGrid grid, BitSet part, BitSet cells, List<Place> places) {
    return new ArrayList<>(
        places.stream().filter(place -> cellOf(grid, part, cells, place).isPresent()).toList());
  }

  /**
   * Of some cells that in which a place is, or, where none of the part is there, one beside it:
   * robots come from its middle.
   */
  private static Optional<Integer> cellOf(
      OccupancyGrid grid, BitSet part, BitSet cells, Place place) {
    Cell own = grid.cellAt(place.position());
    return (grid.contains(own) && part.get(grid.index(own))
            ? Stream.of(own)
            : grid.cellsAround(place.position(), 1).stream())
        .map(grid::index)
        .filter(cells::get)
        .findFirst();
  }

  /**
   * The cells that moves lead to from one.
   *
   * @param unseen the cells that may be found; those that are found are taken out
   */
  private static BitSet flood(OccupancyGrid room, BitSet unseen, int start, Moves moves) {
    BitSet part = new BitSet();
    flood(room, unseen, start, moves, part::set);
    return part;
  }

  private static void flood(
      OccupancyGrid room, BitSet unseen, int start, Moves moves, IntConsumer found) {
    int[] open = new int[64];
    int count = 0;
    open[count++] = start;
    unseen.clear(start);
    int width = room.width();
    while (count > 0) {
      int cell = open[--count];
      found.accept(cell);
      int forbidden = moves.forbidden(room, cell);
      int column = cell % width;
      int[] next = {
        column < width - 1 ? cell + 1 : -1, cell - width, column > 0 ? cell - 1 : -1, cell + width
      };
      for (int i = 0; i < next.length; i++) {
        boolean isAllowed = (forbidden >> DIRECTIONS[i] & 1) == 0;
        if (isAllowed && next[i] >= 0 && unseen.get(next[i])) {
          unseen.clear(next[i]);
          if (count == open.length) {
            open = Arrays.copyOf(open, 2 * count);
          }
          open[count++] = next[i];
        }
      }
    }
  }

  boolean isEmpty() {
    return reached.isEmpty();
  }

  /** Why no task could have the place as its goal, or none would end after it. */
  Optional<Sentence> objection(Place place) {
    boolean isReached = cellOf(grid, connected, reached, place).isPresent();
    boolean isLeft = cellOf(grid, connected, left, place).isPresent();
    if (isReached && isLeft) {
      return Optional.empty();
    }
    Phrase text =
        isReached
            ? Phrase.PLACE_NOT_LEFT
            : isLeft ? Phrase.PLACE_NOT_REACHED : Phrase.PLACE_CUT_OFF;
    return Optional.of(text.with(place.name()));
  }
}
