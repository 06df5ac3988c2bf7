package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.formation.Shape;
import org.toqa.formation.TrajectoryRules;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

/**
 * Paths that a formation can be led along, as {@link FormationSearch} finds them for its leader, in
 * sections. Confined to one thread.
 */
final class FormationPlanner {
  /** A robot that has come to its place is no farther from it, metres. */
  private static final double PLACE_TOLERANCE = 0.01;

  /** Radians. */
  private static final double HEADING_TOLERANCE = 0.02;

  /** Sections end at least so far apart, metres. */
  private static final double PASSING_PLACE_SPACING = 0.3;

  private final OccupancyGrid grid;
  private final SectionFitter fitter;

  FormationPlanner(OccupancyGrid grid, SectionFitter fitter) {
    this.grid = grid;
    this.fitter = fitter;
  }

  /**
   * Where the path of a formation begins whose leader is there: on the lattice if it is but for
   * what a robot may be off its place. It is drawn onto its path as it sets out; a path that began
   * beside the lattice would need room to get onto it, which a place between machines has not.
   */
  static Pose start(OccupancyGrid grid, Pose leader) {
    Pose onLattice = FormationLattice.of(grid).nearest(leader);
    return isAtPlace(onLattice, leader) ? onLattice : leader;
  }

  /** Whether who was sent to a place has come there. */
  static boolean isAtPlace(Pose place, Pose pose) {
    return place.distanceTo(pose) < PLACE_TOLERANCE
        && Math.abs(Angles.difference(pose.theta(), place.theta())) < HEADING_TOLERANCE;
  }

  /**
   * The shortest path on which the formation meets nothing.
   *
   * @param goal where the load is carried, metres, map frame
   * @param solid walls and obstacles
   * @param claimed what others have or will need
   */
  Optional<List<Section>> path(
      TrafficRobot robot,
      FormationFootprint formation,
      Vec2 goal,
      BitSet solid,
      List<SweptArea> claimed) {
    Pose start = robot.committedEnd();
    return Stream.of(FormationClearance.MARGIN, FormationClearance.LEAST_MARGIN)
        .map(margin -> new FormationClearance(grid, formation, start, solid, claimed, margin))
        .flatMap(clearance -> path(robot, formation.shape(), start, goal, clearance).stream())
        .findFirst();
  }

  private Optional<List<Section>> path(
      TrafficRobot robot, Shape shape, Pose start, Vec2 goal, FormationClearance clearance) {
    TrajectoryRules rules = new TrajectoryRules(shape, robot.speeds().forward());
    SegmentFitter arcs =
        new SegmentFitter(robot.speeds(), rules.cornerLength(FormationLattice.EIGHTH));
    return new FormationSearch(grid, shape, clearance, start, goal, robot.speeds(), arcs)
        .trajectory()
        .map(rules::slowed)
        .filter(trajectory -> rules.firstBreach(trajectory).isEmpty())
        .filter(clearance::isKeptOn)
        .map(trajectory -> sections(robot, trajectory))
        .filter(sections -> !sections.isEmpty());
  }

  private List<Section> sections(TrafficRobot robot, Trajectory trajectory) {
    return fitter.split(
        robot,
        trajectory,
        new PassingPlaces.Spaced(Math.max(PASSING_PLACE_SPACING, grid.resolution())));
  }
}
