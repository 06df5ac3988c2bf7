package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.toqa.formation.Shape;
import org.toqa.formation.TrajectoryRules;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
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

  /** Kept from walls round the start, metres, in the order in which they are tried. */
  static final List<Double> MARGINS =
      List.of(FormationClearance.MARGIN, FormationClearance.LEAST_MARGIN);

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
    return MARGINS.stream()
        .map(margin -> new FormationClearance(grid, formation, start, solid, claimed, margin))
        .flatMap(
            clearance ->
                trajectory(
                    grid, formation.shape(), start, goal, robot.speeds(), clearance, new BitSet())
                    .stream())
        .map(trajectory -> sections(robot, trajectory))
        .findFirst();
  }

  /**
   * The same, not cut into sections.
   *
   * @param dead as in {@link FormationSearch#trajectory}
   */
  static Optional<Trajectory> trajectory(
      OccupancyGrid grid,
      Shape shape,
      Pose start,
      Vec2 goal,
      DriveSpeeds speeds,
      FormationClearance clearance,
      BitSet dead) {
    TrajectoryRules rules = new TrajectoryRules(shape, speeds.forward());
    return new FormationSearch(grid, shape, clearance, start, goal, speeds)
        .trajectory(dead)
        .map(rules::slowed)
        .filter(trajectory -> rules.firstBreach(trajectory).isEmpty())
        .filter(clearance::isKeptOn)
        .filter(trajectory -> !trajectory.segments().isEmpty());
  }

  private List<Section> sections(TrafficRobot robot, Trajectory trajectory) {
    return fitter.split(
        robot,
        trajectory,
        new PassingPlaces.Spaced(Math.max(PASSING_PLACE_SPACING, grid.resolution())));
  }
}
