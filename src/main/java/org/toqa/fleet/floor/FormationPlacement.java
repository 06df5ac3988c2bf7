package org.toqa.fleet.floor;

import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.formation.GroupMobility;
import org.toqa.formation.LoadHolds;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.floor.FormationFootprint;
import org.toqa.traffic.floor.FormationPaths;

/**
 * Finds places round a load where all its robots can be, and from where the group has a path along
 * all its stops: {@link Shape#around} in eight headings, its places moved as {@link LoadPlaces}
 * says. A load lies along the heading; a square one also cornerwise, its sides along the map.
 * Shapes that share the load evenly come first, then narrow ones, with robots behind each other,
 * for narrow ways. A function of its arguments: a restarted server finds the same. Any thread may
 * ask.
 */
final class FormationPlacement {
  private static final int EIGHTHS = 8;

  private static final double EIGHTH = Math.PI / 4;

  /** Metres; shapes that differ by less are alike. */
  private static final double ALIKE = 0.05;

  private final OccupancyGrid grid;
  private final Margins margins;

  FormationPlacement(OccupancyGrid grid, Margins margins) {
    this.grid = grid;
    this.margins = margins;
  }

  /**
   * @param object where the load is, metres, map frame
   * @param stops where it is carried, one after the other, metres, map frame
   * @param radius of the largest robot, metres
   * @param mobility how they can be led
   * @return empty where there is no room for them or no path, wherever the load faces
   */
  Optional<Formation> find(
      Vec2 object,
      List<Vec2> stops,
      int robots,
      @Nullable LoadSize requestedSize,
      double radius,
      GroupMobility mobility) {
    LoadSize size = requestedSize == null ? LoadSize.DEFAULT : requestedSize;
    return firstWithPath(around(object, robots, size, radius, mobility), legs(stops));
  }

  /** The paths to each of these places. */
  List<FormationPaths> legs(List<Vec2> stops) {
    return stops.stream().map(stop -> new FormationPaths(grid, margins, stop)).toList();
  }

  /** The first one that has all paths without a shift; where there is none, with shifts. */
  static Optional<Formation> firstWithPath(List<Formation> formations, List<FormationPaths> legs) {
    return Stream.of(false, true)
        .flatMap(
            shifting ->
                formations.stream()
                    .filter(formation -> !shifting || formation.shape().mobility().canShift())
                    .filter(formation -> passedLegs(formation, legs, shifting) == legs.size()))
        .findFirst();
  }

  /**
   * How many legs it has a path for, one after the other, before the first one that it has none
   * for.
   *
   * @param shifting whether it may be led sideways on legs that have no other path
   */
  static int passedLegs(Formation formation, List<FormationPaths> legs, boolean shifting) {
    Pose leader = formation.pose(0);
    int last = legs.size() - 1;
    for (int leg = 0; leg < last; leg++) {
      Optional<Pose> end = legs.get(leg).endOfPath(formation.group(), leader, shifting);
      if (end.isEmpty()) {
        return leg;
      }
      leader = end.get();
    }
    return legs.get(last).hasPath(formation.group(), leader, shifting) ? legs.size() : last;
  }

  /** Those that have room where the load is, the best first. */
  List<Formation> around(
      Vec2 object, int robots, LoadSize size, double radius, GroupMobility mobility) {
    Shape ideal = Shape.around(robots, size.length(), size.width(), radius);
    return IntStream.range(0, EIGHTHS)
        .boxed()
        .flatMap(eighths -> at(object, eighths, ideal, size, radius, mobility))
        .sorted(
            Comparator.<Formation>comparingLong(f -> Math.round(f.shape().imbalance() / ALIKE))
                .thenComparingLong(f -> Math.round(f.group().width() / ALIKE)))
        .toList();
  }

  /** Whether robots so placed can hold a load; if so, then with any shares. */
  private static boolean canHold(Shape shape, LoadSize size, double turn) {
    List<Double> alike = Collections.nCopies(1 + shape.followers().size(), 1.0);
    return LoadHolds.of(shape, size.length(), size.width(), turn, alike).isPresent();
  }

  private Stream<Formation> at(
      Vec2 object, int eighths, Shape ideal, LoadSize size, double radius, GroupMobility mobility) {
    Pose load = new Pose(object.x(), object.y(), eighths * EIGHTH);
    double turn = Formation.turnOf(load, size);
    // what a follower may be off its place beyond what any robot may be beside its path
    double beyond = mobility.law().tolerance() - Trajectory.MAX_DEVIATION;
    return Stream.of(false, true)
        .flatMap(
            isNarrow ->
                new LoadPlaces(grid, load, size, turn, radius, isNarrow).nearest(ideal).stream())
        .filter(shape -> canHold(shape, size, turn))
        .distinct()
        .map(shape -> shape.withMobility(mobility))
        .map(
            shape ->
                new Formation(
                    shape,
                    load,
                    size,
                    new FormationFootprint(shape, radius + beyond, size.length(), size.width())));
  }
}
