package org.toqa.app.bench;

import java.util.BitSet;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;

/**
 * A random scene of CSM-MAMRS's size: 250 x 250 cm in cells of 1 cm, with discs and turned
 * rectangles as obstacles. Start and goal are places where the robot fits, far from each other, and
 * the straight line between them is blocked.
 *
 * @param from metres, map frame
 * @param to metres, map frame
 */
record SmoothScene(OccupancyGrid grid, Vec2 from, Vec2 to) {
  static final double SIDE = 2.5;
  private static final int CELLS = 250;
  private static final double RESOLUTION = SIDE / CELLS;
  private static final int FEWEST_OBSTACLES = 8;
  private static final int MOST_OBSTACLES = 22;

  /** Metres; half the longer side of the largest obstacle. */
  private static final double LARGEST = 0.35;

  private static final double SMALLEST = 0.04;

  /** Metres between start and goal. */
  private static final double NEAREST = 1.4;

  private static final int TRIES = 1000;

  /**
   * @param radius of the robot, metres
   * @param seed the same gives the same scene
   */
  static SmoothScene random(double radius, long seed) {
    RandomGenerator random = new SplittableRandom(seed);
    while (true) {
      OccupancyGrid grid = grid(random);
      for (int i = 0; i < TRIES; i++) {
        Vec2 from = point(random);
        Vec2 to = point(random);
        Disc disc = new Disc(radius);
        if (from.distanceTo(to) >= NEAREST
            && disc.isFreeAt(grid, from)
            && disc.isFreeAt(grid, to)
            && !disc.cellsAlong(grid, from, to).stream().allMatch(grid::isFree)) {
          return new SmoothScene(grid, from, to);
        }
      }
    }
  }

  private static Vec2 point(RandomGenerator random) {
    return new Vec2(SIDE * random.nextDouble(), SIDE * random.nextDouble());
  }

  private static OccupancyGrid grid(RandomGenerator random) {
    BitSet occupied = new BitSet();
    int obstacles = random.nextInt(FEWEST_OBSTACLES, MOST_OBSTACLES + 1);
    for (int i = 0; i < obstacles; i++) {
      addObstacle(random, occupied);
    }
    return new OccupancyGrid(CELLS, CELLS, RESOLUTION, Vec2.ZERO, occupied);
  }

  private static void addObstacle(RandomGenerator random, BitSet occupied) {
    Vec2 middle = point(random);
    double angle = Math.PI * random.nextDouble();
    double length = SMALLEST + (LARGEST - SMALLEST) * random.nextDouble();
    double breadth = SMALLEST + (length - SMALLEST) * random.nextDouble();
    boolean isDisc = random.nextBoolean();
    for (int row = 0; row < CELLS; row++) {
      for (int column = 0; column < CELLS; column++) {
        Vec2 cell = new Vec2(column + 0.5, CELLS - row - 0.5).times(RESOLUTION);
        Vec2 seen = cell.minus(middle).rotated(-angle);
        boolean isInside =
            isDisc
                ? seen.norm() <= breadth
                : Math.abs(seen.x()) <= length && Math.abs(seen.y()) <= breadth;
        if (isInside) {
          occupied.set(row * CELLS + column);
        }
      }
    }
  }
}
