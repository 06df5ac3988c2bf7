package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.toqa.formation.Shape;
import org.toqa.formation.TrajectoryRules;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;
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

  /** What was searched in vain among others is not searched sooner again. */
  private static final Duration SHORTEST_PAUSE = Duration.ofSeconds(2);

  /** It is searched again after twice as long each time, and that at most. */
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(16);

  /** So many searches of a robot's are remembered, besides that among nobody. */
  private static final int REMEMBERED = 3;

  private final OccupancyGrid grid;
  private final Margins margins;
  private final SectionFitter fitter;

  /** By robot: what was found since nothing changed but the others. */
  private final Map<String, Found> found = new HashMap<>();

  /** What a search depends on, but for what others have or will need. */
  private record Question(
      FormationFootprint formation, Pose start, Vec2 goal, BitSet solid, DriveSpeeds speeds) {
    boolean isSameAs(Question other) {
      return formation == other.formation
          && solid.equals(other.solid)
          && start.equals(other.start)
          && goal.equals(other.goal)
          && speeds.equals(other.speeds);
    }
  }

  private static final class Found {
    final Question question;

    /** Were nobody else there. */
    final Optional<Course> alone;

    /** By what others had or would need, the oldest first. */
    final Map<List<SweptArea>, Optional<Trajectory>> among = new LinkedHashMap<>();

    /** Until then it is not searched among others for who wants to set out. */
    private Instant pauseEnd = Instant.MIN;

    private Duration pause = SHORTEST_PAUSE;

    Found(Question question, Optional<Course> alone) {
      this.question = question;
      this.alone = alone;
    }

    boolean isPause(Instant now) {
      return pauseEnd.isAfter(now);
    }

    void pause(Instant now) {
      pauseEnd = now.plus(pause);
      pause = pause.compareTo(LONGEST_PAUSE) < 0 ? pause.multipliedBy(2) : pause;
    }

    /** What was found and may be free now, that alone first. */
    Stream<Trajectory> trajectories() {
      return Stream.concat(
          alone.map(Course::trajectory).stream(),
          among.values().stream().flatMap(Optional::stream));
    }
  }

  /**
   * @param rules by which it was found
   */
  private record Course(Trajectory trajectory, Rules rules) {}

  /**
   * @param margin kept from walls round the start, metres
   * @param shifting whether the group may be led sideways
   */
  record Rules(double margin, boolean shifting) {}

  FormationPlanner(OccupancyGrid grid, Margins margins, SectionFitter fitter) {
    this.grid = grid;
    this.margins = margins;
    this.fitter = fitter;
  }

  /**
   * In the order in which they are tried, so that what is proved is what is driven.
   *
   * @param canShift whether it may be led sideways, where it has no other path
   */
  static Stream<Rules> rules(Margins margins, boolean canShift) {
    return Stream.of(false, true)
        .limit(canShift ? 2 : 1)
        .flatMap(
            shifting ->
                Stream.of(margins.formation(), Margins.LEAST)
                    .distinct()
                    .map(margin -> new Rules(margin, shifting)));
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
   * The shortest path on which the formation meets nothing, with the margin round its start that it
   * had alone. What is asked again is not searched again, as where no other robot has changed
   * either.
   *
   * @param goal where the load is carried, metres, map frame
   * @param solid walls and obstacles; nobody changes them afterwards
   * @param claimed what others have or will need
   */
  Optional<List<Section>> path(
      TrafficRobot robot,
      FormationFootprint formation,
      Vec2 goal,
      BitSet solid,
      List<SweptArea> claimed) {
    Found known = found(robot, formation, goal, solid);
    Optional<Trajectory> trajectory = known.alone.map(Course::trajectory);
    return (claimed.isEmpty() || trajectory.isEmpty() ? trajectory : among(known, claimed))
        .map(t -> sections(robot, t));
  }

  /**
   * One that is free now: what is known, or what is searched, but not at once again where that was
   * in vain: a search among many that drive looks at much of the floor. For who waits long its way
   * is cleared ({@link RightOfWay}), which is known and takes no search.
   */
  Optional<List<Section>> freePath(
      TrafficRobot robot,
      FormationFootprint formation,
      Vec2 goal,
      BitSet solid,
      List<SweptArea> claimed,
      Instant now) {
    Found known = found(robot, formation, goal, solid);
    if (known.alone.isEmpty()) {
      return Optional.empty();
    }
    Optional<Trajectory> free =
        known.trajectories().filter(t -> isFree(known.question, t, claimed)).findFirst();
    if (free.isEmpty() && !known.isPause(now)) {
      free = trajectory(known.question, claimed, known.alone.get().rules);
      if (free.isEmpty()) {
        known.pause(now);
      }
    }
    return free.map(t -> sections(robot, t));
  }

  private Found found(TrafficRobot robot, FormationFootprint formation, Vec2 goal, BitSet solid) {
    Question question = new Question(formation, robot.committedEnd(), goal, solid, robot.speeds());
    Found known = found.get(robot.name);
    if (known == null || !known.question.isSameAs(question)) {
      known = new Found(question, alone(question));
      found.put(robot.name, known);
    }
    return known;
  }

  private Optional<Course> alone(Question question) {
    return rules(margins, question.formation.shape().mobility().canShift())
        .flatMap(
            rules -> trajectory(question, List.of(), rules).map(t -> new Course(t, rules)).stream())
        .findFirst();
  }

  private Optional<Trajectory> among(Found known, List<SweptArea> claimed) {
    Course alone = known.alone.orElseThrow();
    Optional<Trajectory> same = known.among.get(claimed);
    if (same != null) {
      return same;
    }
    Optional<Trajectory> trajectory =
        isFree(known.question, alone.trajectory, claimed)
            ? Optional.of(alone.trajectory)
            : trajectory(known.question, claimed, alone.rules);
    if (known.among.size() == REMEMBERED) {
      known.among.remove(known.among.keySet().iterator().next());
    }
    known.among.put(List.copyOf(claimed), trajectory);
    return trajectory;
  }

  /** Whether others are nowhere on a path. */
  private static boolean isFree(Question question, Trajectory trajectory, List<SweptArea> claimed) {
    SweptArea standing = SweptArea.at(question.formation.discs(question.start));
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      SweptArea swept = question.formation.sweptArea(pose, segment);
      if (!claimed.stream().allMatch(area -> Clearance.isKept(standing, swept, area))) {
        return false;
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return true;
  }

  private Optional<Trajectory> trajectory(Question question, List<SweptArea> claimed, Rules rules) {
    FormationFootprint formation = question.formation;
    return trajectory(
        grid,
        formation.shape(),
        question.start,
        question.goal,
        question.speeds,
        new FormationClearance(
            grid,
            formation,
            question.start,
            question.solid,
            claimed,
            margins.formation(),
            rules.margin),
        rules.shifting,
        new BitSet());
  }

  /** Forgets robots that lead no formation any more. */
  void keepOnly(Set<String> formations) {
    found.keySet().retainAll(formations);
  }

  /**
   * The same, not cut into sections.
   *
   * @param shifting whether it may be led sideways
   * @param dead as in {@link FormationSearch#trajectory}
   */
  static Optional<Trajectory> trajectory(
      OccupancyGrid grid,
      Shape shape,
      Pose start,
      Vec2 goal,
      DriveSpeeds speeds,
      FormationClearance clearance,
      boolean shifting,
      BitSet dead) {
    TrajectoryRules rules = new TrajectoryRules(shape, speeds.forward());
    return new FormationSearch(grid, shape, clearance, start, goal, speeds, shifting)
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
