package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
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
   * The shortest path on which the formation meets none of these cells.
   *
   * @param goal where the load is carried, metres, map frame
   */
  Optional<List<Section>> path(
      TrafficRobot robot, FormationFootprint formation, Vec2 goal, BitSet blocked) {
    Pose start = robot.releasedEnd();
    TrajectoryRules rules = new TrajectoryRules(formation.shape(), robot.speeds().forward());
    SegmentFitter arcs =
        new SegmentFitter(robot.speeds(), rules.cornerLength(FormationLattice.EIGHTH));
    return new FormationSearch(grid, formation, start, goal, blocked, arcs)
        .waypoints()
        .map(waypoints -> rules.slowed(arcs.fit(start, waypoints)))
        .filter(trajectory -> rules.firstBreach(trajectory).isEmpty())
        .map(trajectory -> sections(robot, trajectory))
        .filter(
            sections ->
                !sections.isEmpty()
                    && sections.stream().noneMatch(s -> s.cells().intersects(blocked)));
  }

  private List<Section> sections(TrafficRobot robot, Trajectory trajectory) {
    return fitter.split(
        robot,
        trajectory,
        new PassingPlaces.Spaced(Math.max(PASSING_PLACE_SPACING, grid.resolution())));
  }
}
