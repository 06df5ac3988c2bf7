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
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;

/** Small floors with robots on them, for properties. */
public final class RandomFloors {
  private RandomFloors() {}

  /** Robots on free cells, no two on one, and goals on free cells, no two alike. */
  public record Floor(OccupancyGrid grid, List<Cell> starts, List<Cell> goals) {

    /** Drawn, so that a failing sample can be read. */
    @Override
    public String toString() {
      StringBuilder text = new StringBuilder(starts + " to " + goals);
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
              return floor(new OccupancyGrid(width, height, 1, Vec2.ZERO, occupied), count, random);
            });
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
