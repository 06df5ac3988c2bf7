package org.toqa.fleet.floor;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.formation.LoadHolds;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.motion.Trajectory;

/**
 * Moves the places of a shape to where robots can be: to the middle of cells that are clear of
 * walls, off the load, and so far from each other that robots come and go. Of all such sets it
 * takes the one that shares the load most evenly, its middle in theirs, then the one that moves
 * them least; or else, for narrow ways, the one that is narrowest of those that can hold the load,
 * robots behind each other: they hold it off the middle of their edges.
 *
 * <p>Places are tried depth first, the nearest cells first; after so many sets the best one counts.
 * One object is for one load.
 */
final class LoadPlaces {
  /** Metres of air between a robot and the load at least. */
  private static final double CLEARANCE = 0.01;

  /** Between the edges of two robots, metres: nearer than that none comes to another. */
  private static final double BETWEEN_ROBOTS = 2 * Trajectory.MAX_DEVIATION;

  /** Cells that a place may be moved by. */
  private static final double MAX_SHIFT = 1;

  /** The same of a follower where they are to be narrow: to behind another robot. */
  private static final double MAX_SHIFT_BEHIND = 1.5;

  private static final int MAX_SETS = 1_000;

  /** Metres; what differs by less is alike. */
  private static final double ALIKE = 0.01;

  private static final double ROUNDING = 1e-6;

  private final OccupancyGrid grid;
  private final Pose load;
  private final LoadSize size;
  private final double turn;
  private final double radius;
  private final boolean isNarrow;
  private final List<List<Vec2>> options = new ArrayList<>();
  private List<Vec2> ideal = List.of();
  private @Nullable Shape best;
  private double bestMoved;
  private int sets;

  /**
   * @param load where it is, and which way the group faces, map frame
   * @param turn of the load's length from that, radians
   * @param radius of the largest robot, metres
   * @param isNarrow whether the narrowest set is wanted, not the one that shares most evenly
   */
  LoadPlaces(
      OccupancyGrid grid, Pose load, LoadSize size, double turn, double radius, boolean isNarrow) {
    this.grid = grid;
    this.load = load;
    this.size = size;
    this.turn = turn;
    this.radius = radius;
    this.isNarrow = isNarrow;
  }

  /** Empty where there is no room for them. */
  Optional<Shape> nearest(Shape shape) {
    ideal = new ArrayList<>(shape.followers());
    ideal.addFirst(shape.leader());
    options.add(standable(shape.leader(), MAX_SHIFT));
    double shift = isNarrow ? MAX_SHIFT_BEHIND : MAX_SHIFT;
    shape.followers().forEach(place -> options.add(standable(place, shift)));
    choose(new ArrayList<>());
    return Optional.ofNullable(best);
  }

  /**
   * The cells' middles near to a place where a robot can be, nearest first, in the load's frame.
   *
   * @param shift cells that it may be moved by
   */
  private List<Vec2> standable(Vec2 place, double shift) {
    Vec2 onMap = load.compose(new Pose(place.x(), place.y(), 0)).position();
    return grid.cellsAround(onMap, (int) Math.ceil(shift)).stream()
        .map(grid::centre)
        .filter(middle -> middle.distanceTo(onMap) <= shift * grid.resolution())
        .filter(middle -> new Disc(radius).isFreeAt(grid, middle))
        .map(middle -> load.relative(new Pose(middle.x(), middle.y(), 0)).position())
        .filter(seen -> gap(seen) >= radius + CLEARANCE - ROUNDING)
        .sorted(Comparator.comparingDouble(seen -> Math.rint(seen.distanceTo(place) / ALIKE)))
        .toList();
  }

  /** From a point to the load's edge, metres. */
  private double gap(Vec2 point) {
    Vec2 seen = point.rotated(-turn);
    return Math.hypot(
        Math.max(0, Math.abs(seen.x()) - size.length() / 2),
        Math.max(0, Math.abs(seen.y()) - size.width() / 2));
  }

  private void choose(List<Vec2> places) {
    if (places.size() == options.size()) {
      compare(new Shape(places.getFirst(), places.subList(1, places.size())));
      return;
    }
    for (Vec2 place : options.get(places.size())) {
      boolean isApart =
          places.stream()
              .allMatch(other -> place.distanceTo(other) >= 2 * radius + BETWEEN_ROBOTS - ROUNDING);
      if (isApart && sets < MAX_SETS) {
        places.add(place);
        choose(places);
        places.removeLast();
      }
    }
  }

  private void compare(Shape shape) {
    sets++;
    double moved = shape.leader().distanceTo(ideal.getFirst());
    for (int i = 1; i < ideal.size(); i++) {
      moved += shape.followers().get(i - 1).distanceTo(ideal.get(i));
    }
    if (isNarrow && !canHold(shape)) {
      return;
    }
    if (best == null || isBetter(shape, moved, best)) {
      best = shape;
      bestMoved = moved;
    }
  }

  private boolean isBetter(Shape shape, double moved, Shape than) {
    double narrower = isNarrow ? breadth(than) - breadth(shape) : 0;
    double evener = than.imbalance() - shape.imbalance();
    if (Math.abs(narrower) > ALIKE) {
      return narrower > 0;
    }
    return Math.abs(evener) > ALIKE ? evener > 0 : moved < bestMoved - ALIKE;
  }

  /** Metres from the middle of its rightmost robot to that of its leftmost. */
  private static double breadth(Shape shape) {
    DoubleSummaryStatistics aside =
        Stream.concat(Stream.of(shape.leader()), shape.followers().stream())
            .mapToDouble(Vec2::y)
            .summaryStatistics();
    return aside.getMax() - aside.getMin();
  }

  /** Whether robots so placed can hold the load; if so, then with any shares. */
  private boolean canHold(Shape shape) {
    List<Double> alike = Collections.nCopies(options.size(), 1.0);
    return LoadHolds.of(shape, size.length(), size.width(), turn, alike).isPresent();
  }
}
