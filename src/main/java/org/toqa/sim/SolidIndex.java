package org.toqa.sim;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.LongAdder;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;

/**
 * Finds what a ray meets without asking everything on the floor: solids are kept by the square of 1
 * m in which their middles are, and only those are asked whose square is near the ray. A ray costs
 * what is near it, however many there are; a solid that moves costs something where it changes its
 * square.
 *
 * <p>May be used by any thread. A solid is added, moved and removed by one at a time, and seen by
 * all others meanwhile.
 */
final class SolidIndex {
  /** Metres. */
  private static final double SQUARE = 1;

  private final Map<Cell, List<Solid>> squares = new ConcurrentHashMap<>();
  private final LongAdder asked = new LongAdder();

  /** Metres, of all that were ever added: how far from its middle a ray may meet a solid. */
  private volatile double largestRadius;

  synchronized void add(Solid solid) {
    largestRadius = Math.max(largestRadius, solid.radius());
    in(square(solid.at())).add(solid);
  }

  void remove(Solid solid) {
    in(square(solid.at())).remove(solid);
  }

  void move(Solid solid, Pose place) {
    Cell from = square(solid.at());
    Cell to = square(place);
    if (from.equals(to)) {
      solid.moveTo(place);
      return;
    }
    in(to).add(solid); // a ray meets it twice rather than never
    solid.moveTo(place);
    in(from).remove(solid);
  }

  private List<Solid> in(Cell square) {
    return squares.computeIfAbsent(square, _ -> new CopyOnWriteArrayList<>());
  }

  /**
   * Metres along a ray until it meets a solid.
   *
   * @param ray from where and in which direction, map frame
   * @param farthest metres; the answer where nothing is nearer
   * @param self whose ray it is, which it does not meet; null: nobody's
   */
  double distance(Pose ray, double farthest, @Nullable Solid self) {
    Vec2 start = ray.position();
    Vec2 end = start.plus(new Vec2(Math.cos(ray.theta()), Math.sin(ray.theta())).times(farthest));
    double reach = largestRadius;
    Cell low = square(Math.min(start.x(), end.x()) - reach, Math.min(start.y(), end.y()) - reach);
    Cell high = square(Math.max(start.x(), end.x()) + reach, Math.max(start.y(), end.y()) + reach);
    double nearest = farthest;
    for (int column = low.column(); column <= high.column(); column++) {
      for (int row = low.row(); row <= high.row(); row++) {
        for (Solid solid : squares.getOrDefault(new Cell(column, row), List.of())) {
          if (solid != self) {
            asked.increment();
            nearest = Math.min(nearest, solid.distance(ray, nearest));
          }
        }
      }
    }
    return nearest;
  }

  /** How many solids have been asked where a ray meets them. */
  long asked() {
    return asked.sum();
  }

  private static Cell square(Pose at) {
    return square(at.x(), at.y());
  }

  private static Cell square(double x, double y) {
    return new Cell((int) Math.floor(x / SQUARE), (int) Math.floor(y / SQUARE));
  }
}
