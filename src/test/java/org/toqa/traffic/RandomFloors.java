package org.toqa.traffic;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Cell;
import org.toqa.grid.Direction;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;

/** Small floors with robots on them, for properties. */
public final class RandomFloors {
  private RandomFloors() {}

  /** Robots on free cells, no two on one, and goals on free cells, no two alike. */
  public record Floor(OccupancyGrid grid, List<Cell> starts, List<Cell> goals) {

    /** Drawn, so that a failing sample can be read. */
    @Override
    public String toString() {
      StringBuilder text = new StringBuilder(starts + " to " + goals);
      text.append(grid.rules().oneWay()).append(grid.rules().approaches());
      for (int row = 0; row < grid.height(); row++) {
        text.append('\n');
        for (int column = 0; column < grid.width(); column++) {
          text.append(grid.isFree(column, row) ? '.' : '#');
        }
      }
      return text.toString();
    }
  }

  /**
   * @param walls the most walls, as a share of the cells
   * @param robots the most robots; fewer where there is no room
   */
  public static Arbitrary<Floor> strewn(int longestSide, double walls, int robots) {
    Arbitrary<Integer> side = Arbitraries.integers().between(1, longestSide);
    return Combinators.combine(
            side,
            side,
            Arbitraries.doubles().between(0, walls),
            Arbitraries.integers().between(1, robots),
            Arbitraries.longs().withoutEdgeCases())
        .as(
            (width, height, density, count, seed) -> {
              Random random = new Random(seed);
              BitSet occupied = new BitSet();
              for (int i = 1; i < width * height; i++) {
                occupied.set(i, random.nextDouble() < density);
              }
              OccupancyGrid grid = new OccupancyGrid(width, height, 1, Vec2.ZERO, occupied);
              return floor(withDirections(grid, new Random(~seed)), count, random);
            });
  }

  /** On every fourth floor, areas that are driven one way and a cell that is entered one way. */
  private static OccupancyGrid withDirections(OccupancyGrid grid, Random random) {
    return random.nextInt(4) > 0
        ? grid
        : grid.withRules(
            new MoveRules(
                List.of(oneWay(grid, 4, random), oneWay(grid, 4, random)),
                random.nextBoolean() ? List.of(oneWay(grid, 1, random)) : List.of(),
                List.of()));
  }

  private static OneWay oneWay(OccupancyGrid grid, int longest, Random random) {
    Vec2 low = new Vec2(random.nextInt(grid.width()), random.nextInt(grid.height()));
    return new OneWay(
        new Area(low, 1 + random.nextInt(longest), 1 + random.nextInt(longest)),
        Direction.values()[random.nextInt(4)]);
  }

  /**
   * An open floor with some pillars, no two of which touch, so that there are no dead ends and no
   * aisles; robots on a quarter of it at most.
   */
  public static Floor roomy(Random random) {
    int side = 4 + random.nextInt(5);
    BitSet occupied = new BitSet();
    for (int row = 1; row < side - 1; row += 2) {
      for (int column = 1; column < side - 1; column += 2) {
        occupied.set(row * side + column, random.nextInt(3) == 0);
      }
    }
    OccupancyGrid grid = new OccupancyGrid(side, side, 1, Vec2.ZERO, occupied);
    return floor(grid, 1 + random.nextInt(side * side / 4), random);
  }

  private static Floor floor(OccupancyGrid grid, int most, Random random) {
    List<Cell> free =
        new ArrayList<>(
            IntStream.range(0, grid.width() * grid.height())
                .mapToObj(grid::cell)
                .filter(grid::isFree)
                .toList());
    int robots = Math.min(most, free.size());
    Collections.shuffle(free, random);
    List<Cell> starts = List.copyOf(free.subList(0, robots));
    Collections.shuffle(free, random);
    return new Floor(grid, starts, List.copyOf(free.subList(0, robots)));
  }
}
