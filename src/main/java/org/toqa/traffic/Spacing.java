package org.toqa.traffic;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * Which vertices cannot be taken at once, as their cells are too narrow for robots that keep their
 * distance: those nearer to each other than that. Robots that stand nearer may part, but a step
 * never brings them nearer. Confined to one thread.
 */
public final class Spacing {
  private static final double ROUNDING = 1e-9;

  private final RoadGraph roads;

  /** The square of the distance that is kept between middles, in cells. */
  private final double squaredDistance;

  /** Columns and rows from a vertex to those that are too near, one pair after the other. */
  private final int[] offsets;

  private final int[] @Nullable [] near;
  private final int[] @Nullable [] opposite;

  /**
   * @param distance kept between the middles of robots, in cells
   */
  public Spacing(RoadGraph roads, double distance) {
    this.roads = roads;
    this.squaredDistance = distance * distance - ROUNDING;
    this.near = new int[roads.vertexCount()][];
    this.opposite = new int[roads.vertexCount() * RoadGraph.DIRECTIONS][];
    int reach = (int) distance;
    int[] found = new int[2 * (2 * reach + 1) * (2 * reach + 1)];
    int count = 0;
    for (int row = -reach; row <= reach; row++) {
      for (int column = -reach; column <= reach; column++) {
        int squared = column * column + row * row;
        if (squared > 0 && squared < squaredDistance) {
          found[count++] = column;
          found[count++] = row;
        }
      }
    }
    this.offsets = Arrays.copyOf(found, count);
  }

  /** Robots may be on any two vertices at once. */
  public static Spacing none(RoadGraph roads) {
    return new Spacing(roads, 1);
  }

  /** Whether there are no two vertices that cannot be taken at once. */
  public boolean isNone() {
    return offsets.length == 0;
  }

  /** The other vertices that cannot be taken while this one is; not to be changed. */
  public int[] near(int vertex) {
    int[] known = near[vertex];
    if (known == null) {
      known = new int[offsets.length / 2];
      int count = 0;
      for (int k = 0; k < offsets.length; k += 2) {
        int other =
            roads.vertex(roads.columnOf(vertex) + offsets[k], roads.rowOf(vertex) + offsets[k + 1]);
        if (other != RoadGraph.NONE) {
          known[count++] = other;
        }
      }
      known = Arrays.copyOf(known, count);
      near[vertex] = known;
    }
    return known;
  }

  /** Whether two vertices are the same, or cannot be taken at once. */
  public boolean isTooNear(int one, int other) {
    return one == other || (offsets.length > 0 && squared(one, other) < squaredDistance);
  }

  /**
   * Whether two robots may be on these vertices a step after they were on those: as far apart as
   * robots keep, or no nearer than they were.
   */
  public boolean mayBeAt(int one, int other, int oneBefore, int otherBefore) {
    int squared = squared(one, other);
    return squared >= squaredDistance
        || (squared > 0 && squared >= squared(oneBefore, otherBefore));
  }

  private int squared(int one, int other) {
    int columns = roads.columnOf(one) - roads.columnOf(other);
    int rows = roads.rowOf(one) - roads.rowOf(other);
    return columns * columns + rows * rows;
  }

  /**
   * The edges that cannot be driven in the same step as that from a vertex in a direction, since
   * each of the two robots would wait for the other to leave first; not to be changed.
   *
   * @return vertex times {@link RoadGraph#DIRECTIONS} plus direction
   */
  public int[] opposite(int vertex, int direction) {
    int edge = vertex * RoadGraph.DIRECTIONS + direction;
    int[] known = opposite[edge];
    if (known == null) {
      known = findOpposite(vertex, roads.neighbour(vertex, direction));
      opposite[edge] = known;
    }
    return known;
  }

  private int[] findOpposite(int from, int to) {
    int[] around = Arrays.copyOf(near(to), near(to).length + 1);
    around[around.length - 1] = to;
    return Arrays.stream(around)
        .flatMap(
            start ->
                IntStream.range(0, RoadGraph.DIRECTIONS)
                    .filter(
                        d ->
                            roads.neighbour(start, d) != RoadGraph.NONE
                                && isTooNear(roads.neighbour(start, d), from)
                                && start != from)
                    .map(d -> start * RoadGraph.DIRECTIONS + d))
        .toArray();
  }
}
