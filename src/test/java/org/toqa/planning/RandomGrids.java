package org.toqa.planning;

import java.util.BitSet;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
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

/** Grids and queries for properties. */
final class RandomGrids {
  private RandomGrids() {}

  record Query(OccupancyGrid grid, Cell start, Cell goal) {

    /** Drawn, so that a failing sample can be read. */
    @Override
    public String toString() {
      StringBuilder text = new StringBuilder(start + " to " + goal);
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

  /** Cells strewn at random, from empty to crowded; start and goal anywhere, walls included. */
  static Arbitrary<Query> strewn(
      int shortestSide, int longestSide, double crowded, double resolution) {
    Arbitrary<Integer> side = Arbitraries.integers().between(shortestSide, longestSide);
    return strewn(side, side, crowded, resolution);
  }

  /** The same with areas that are driven one way, and cells that are entered one way. */
  static Arbitrary<Query> withDirections(Arbitrary<Query> queries) {
    return Combinators.combine(queries, Arbitraries.longs())
        .as(
            (query, seed) -> {
              Random random = new Random(seed);
              OccupancyGrid grid = query.grid();
              MoveRules rules =
                  new MoveRules(
                      Stream.generate(() -> oneWay(grid, 1 + random.nextInt(6), random))
                          .limit(random.nextInt(4))
                          .toList(),
                      random.nextBoolean() ? List.of(approach(query)) : List.of(),
                      List.of());
              return new Query(grid.withRules(rules), query.start(), query.goal());
            });
  }

  private static OneWay oneWay(OccupancyGrid grid, int most, Random random) {
    double side = grid.resolution();
    double step = random.nextBoolean() ? side : side / 3;
    Vec2 low =
        grid.origin()
            .plus(
                new Vec2(random.nextInt(grid.width()), random.nextInt(grid.height())).times(side));
    return new OneWay(
        new Area(low, (1 + random.nextInt(most)) * step, (1 + random.nextInt(most)) * step),
        Direction.values()[random.nextInt(4)]);
  }

  private static OneWay approach(Query query) {
    OccupancyGrid grid = query.grid();
    double side = grid.resolution();
    Vec2 low = grid.centre(query.goal()).minus(new Vec2(side / 2, side / 2));
    return new OneWay(new Area(low, side, side), Direction.NORTH);
  }

  /** The same, a few cells wide in one direction and more than 64 in the other. */
  static Arbitrary<Query> strewnAlongAnAisle(double crowded) {
    Arbitrary<Integer> narrow = Arbitraries.integers().between(1, 5);
    Arbitrary<Integer> wide = Arbitraries.integers().between(60, 200);
    return Arbitraries.oneOf(strewn(wide, narrow, crowded, 1), strewn(narrow, wide, crowded, 1));
  }

  private static Arbitrary<Query> strewn(
      Arbitrary<Integer> widths, Arbitrary<Integer> heights, double crowded, double resolution) {
    return Combinators.combine(
            widths, heights, Arbitraries.doubles().between(0, crowded), Arbitraries.longs())
        .as(
            (width, height, density, seed) -> {
              Random random = new Random(seed);
              BitSet occupied = new BitSet();
              for (int i = 0; i < width * height; i++) {
                occupied.set(i, random.nextDouble() < density);
              }
              OccupancyGrid grid =
                  new OccupancyGrid(width, height, resolution, new Vec2(-1, 2), occupied);
              return query(grid, random);
            });
  }

  /** Rooms with thin walls and a doorway in each, as buildings have them. */
  static Arbitrary<Query> rooms(double resolution) {
    return Combinators.combine(Arbitraries.integers().between(2, 5), Arbitraries.longs())
        .as(
            (roomSize, seed) -> {
              Random random = new Random(seed);
              int side = 4 * (roomSize + 1) + 1;
              BitSet occupied = new BitSet();
              for (int i = 0; i < side * side; i++) {
                occupied.set(i, i % side % (roomSize + 1) == 0 || i / side % (roomSize + 1) == 0);
              }
              for (int room = 0; room < 16; room++) {
                int column = room % 4 * (roomSize + 1);
                int row = room / 4 * (roomSize + 1);
                int doorway = 1 + random.nextInt(roomSize);
                if (column > 0) {
                  occupied.clear((row + doorway) * side + column);
                }
                if (row > 0) {
                  occupied.clear(row * side + column + 1 + random.nextInt(roomSize));
                }
              }
              return query(new OccupancyGrid(side, side, resolution, Vec2.ZERO, occupied), random);
            });
  }

  /** Wide and narrow places with rough walls: noise from which single cells have been taken. */
  static Arbitrary<Query> caves(int shortestSide, int longestSide) {
    return Combinators.combine(
            Arbitraries.integers().between(shortestSide, longestSide),
            Arbitraries.doubles().between(0.38, 0.45),
            Arbitraries.longs())
        .as(
            (side, density, seed) -> {
              Random random = new Random(seed);
              return query(MadeMaps.cave(side, density, random), random);
            });
  }

  /** Corridors with one path from any place to any other, and walls of one cell. */
  static Arbitrary<Query> mazes(int shortestSide, int longestSide) {
    return Combinators.combine(
            Arbitraries.integers().between(shortestSide, longestSide),
            Arbitraries.integers().between(1, 6),
            Arbitraries.longs())
        .as(
            (side, corridor, seed) -> {
              Random random = new Random(seed);
              return query(MadeMaps.maze(side, corridor, random), random);
            });
  }

  static Query query(OccupancyGrid grid, Random random) {
    return new Query(grid, cell(grid, random), cell(grid, random));
  }

  /** Mostly a free cell. */
  private static Cell cell(OccupancyGrid grid, Random random) {
    int cells = grid.width() * grid.height();
    int any = random.nextInt(cells);
    int free = grid.occupied().nextClearBit(any);
    return grid.cell(free < cells && random.nextInt(8) > 0 ? free : any);
  }
}
