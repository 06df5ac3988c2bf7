package org.toqa.driving;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.avoidance.Encounter;
import org.toqa.avoidance.Encounter.TimedPoint;
import org.toqa.avoidance.MovingDisc;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DifferentialLimits;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.PlanningBudget;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.SmoothPlanner;
import org.toqa.planning.smooth.SmoothResult;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

/**
 * Leads a robot round a disc that would meet it, and back to its line further on (CSM-MAMRS,
 * "dynamic environment"). Where a disc goes in the seconds about the meeting is taken for wall, and
 * the planner of smooth paths ({@link SmoothPlanner}) leads round it, from where the robot could
 * stop at the earliest to some places behind the meeting. A detour counts only if nothing is met on
 * it, at the times at which it will be driven; of those the shortest is taken.
 *
 * <p>It is a function of its arguments. That nothing is driven into does not depend on it ({@link
 * org.toqa.avoidance.SafePace}): where there is no detour, the robot waits.
 */
public final class DetourPlanner {
  /** Seconds ahead that are looked at. */
  private static final double HORIZON = 6;

  /** Seconds before and after the meeting in which the disc's way is wall. */
  private static final double ABOUT = 0.8;

  /** Metres from the meeting to where the robot is back on its line. */
  private static final double[] RETURNS = {0.3, 0.45, 0.65, 0.9};

  /** Metres from where a detour begins to the meeting, at most; the second for want of room. */
  private static final double[] LEAVES = {0.7, 1.5};

  /** Metres that way points keep from walls beyond the radius, as arcs and splines bulge. */
  private static final double HUG = 0.01;

  /** Metres beyond where the robot could stop, at which a detour begins. */
  private static final double LEAD = 0.03;

  /** Share of the margin that is kept on a detour in any case. */
  private static final double KEPT = 0.25;

  private static final int ITERATIONS = 400;

  /** Radians by which a detour may begin or end beside the line's direction. */
  private static final double SMOOTH = 0.02;

  /** Metres: of the arcs on which a detour leaves its line and comes back to it. */
  private static final double ARC = 0.15;

  /** Radians between points of an arc. */
  private static final double ARC_STEP = 0.1;

  /** Radians a metre: a robot hardly follows sharper bends. */
  private static final double MOST_CURVATURE = 14;

  /** Metres that a detour keeps from the disc beyond the margin. */
  private static final double BEYOND = 0.01;

  private final OccupancyGrid grid;
  private final double radius;
  private final double margin;
  private final DifferentialLimits limits;
  private final long seed;

  /**
   * @param grid the walls
   * @param radius of the robot, metres, with what it may be off its path
   * @param margin metres that it keeps from moving discs beyond that
   * @param seed of the random numbers
   */
  public DetourPlanner(
      OccupancyGrid grid, double radius, double margin, DifferentialLimits limits, long seed) {
    this.grid = grid;
    this.radius = radius;
    this.margin = margin;
    this.limits = limits;
    this.seed = seed;
  }

  /**
   * Whom the robot will meet on its line, if it goes on as it may.
   *
   * @param metres driven already
   * @param speed metres a second, now
   */
  public Optional<Encounter> encounter(
      DrivenLine line, double metres, double speed, List<MovingDisc> obstacles) {
    return encounter(line, metres, speed, radius + margin, obstacles);
  }

  private Optional<Encounter> encounter(
      DrivenLine line, double metres, double speed, double reach, List<MovingDisc> obstacles) {
    List<TimedPoint> motion = new LineSpeeds(line, limits).motion(metres, speed, HORIZON);
    return Encounter.first(motion, reach, obstacles);
  }

  /**
   * The line with a detour round whom the robot would meet; nothing where none is found.
   *
   * @param metres driven already; the detour begins further on
   * @param speed metres a second, now
   */
  public Optional<DrivenLine> plan(
      DrivenLine line, double metres, double speed, Encounter meeting, List<MovingDisc> obstacles) {
    double earliest = metres + speed * speed / (2 * limits.acceleration()) + LEAD;
    double met = line.nearest(meeting.place());
    OccupancyGrid swept = withSwept(meeting.seconds(), obstacles);
    DrivenLine best = null;
    for (int i = 0; i < LEAVES.length && best == null; i++) {
      double begin = Math.max(earliest, met - LEAVES[i]);
      if (begin < line.length() && isFreeAt(swept, line.at(begin))) {
        Spaces spaces = new Spaces(DiscSpace.of(swept, radius), DiscSpace.of(swept, radius + HUG));
        for (double beyond : RETURNS) {
          double end = Math.min(line.length(), Math.max(begin, met) + beyond);
          DrivenLine found =
              begin < end && isFreeAt(swept, line.at(end))
                  ? detour(spaces, line, begin, end)
                  : null;
          if (found != null
              && (best == null || found.length() < best.length())
              && encounter(found, metres, speed, radius + KEPT * margin, obstacles).isEmpty()) {
            best = found;
          }
        }
      }
    }
    return Optional.ofNullable(best);
  }

  /**
   * @param narrow of the robot's radius
   * @param wide of a little more
   */
  private record Spaces(DiscSpace narrow, DiscSpace wide) {
    DiscSpace between(Pose from, Pose to) {
      return wide.isFree(from.position()) && wide.isFree(to.position()) ? wide : narrow;
    }
  }

  private boolean isFreeAt(OccupancyGrid swept, Pose pose) {
    return new Disc(radius).isFreeAt(swept, pose.position());
  }

  private @Nullable DrivenLine detour(Spaces spaces, DrivenLine line, double begin, double end) {
    Pose from = line.at(begin);
    Pose to = line.at(end);
    SmoothResult result =
        new SmoothPlanner(SmoothMethod.HYBRID, seed)
            .plan(
                spaces.between(from, to),
                from.position(),
                to.position(),
                PlanningBudget.iterations(ITERATIONS));
    if (!(result instanceof SmoothResult.Found(var path))) {
      return null;
    }
    List<Vec2> bent = bent(path.points(), from, to);
    if (!isFree(spaces.narrow(), bent)) {
      return null;
    }
    SmoothCurve curve = new SplineFitter(spaces.narrow()).fit(bent, from.theta(), to.theta());
    if (curve.pieces().size() != 1 || curve.maxCurvature() > MOST_CURVATURE) {
      return null;
    }
    Vec2 first = curve.pieces().getFirst().velocity(0);
    Vec2 last = curve.pieces().getFirst().velocity(curve.pieces().getFirst().end());
    boolean isSmooth =
        Math.abs(Angles.difference(first.angle(), from.theta())) <= SMOOTH
            && Math.abs(Angles.difference(last.angle(), to.theta())) <= SMOOTH;
    return isSmooth ? line.withDetour(begin, end, DrivenLine.of(curve.pieces())) : null;
  }

  /** The same way points, but left and reached on an arc; none where they are too near for one. */
  private static List<Vec2> bent(List<Vec2> path, Pose from, Pose to) {
    List<Vec2> points = new ArrayList<>(arc(from, path.get(1)));
    points.addAll(path.subList(1, path.size() - 1));
    Pose back = new Pose(to.x(), to.y(), to.theta() + Math.PI);
    List<Vec2> last = arc(back, path.size() == 2 ? points.getLast() : path.get(path.size() - 2));
    points.addAll(last.reversed());
    return points;
  }

  /**
   * Points from a pose on an arc, up to where its tangent leads to a point; none where that is
   * within the arc's circle.
   */
  private static List<Vec2> arc(Pose from, Vec2 to) {
    Vec2 seen = to.minus(from.position()).rotated(-from.theta());
    double side = Math.signum(seen.y());
    // from the middle of the circle: the angle to the point, less that of the tangent's triangle
    Vec2 across = new Vec2(seen.x(), seen.y() - side * ARC);
    if (across.norm() <= ARC) {
      return List.of();
    }
    double angle =
        side == 0
            ? 0
            : Angles.normalise(
                side * (across.angle() - side * Math.acos(ARC / across.norm())) + Math.PI / 2);
    int steps = (int) Math.ceil(Math.max(0, angle) / ARC_STEP);
    List<Vec2> points = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double turned = steps == 0 ? 0 : angle * i / steps;
      Vec2 on = new Vec2(ARC * Math.sin(turned), side * ARC * (1 - Math.cos(turned)));
      points.add(from.position().plus(on.rotated(from.theta())));
    }
    return points;
  }

  private static boolean isFree(DiscSpace space, List<Vec2> path) {
    for (int i = 1; i < path.size(); i++) {
      if (!space.isFree(path.get(i - 1), path.get(i))) {
        return false;
      }
    }
    return path.size() > 1;
  }

  /** The walls, and where the discs are in the seconds about the meeting. */
  private OccupancyGrid withSwept(double meeting, List<MovingDisc> obstacles) {
    BitSet occupied = grid.occupied();
    for (MovingDisc obstacle : obstacles) {
      double from = Math.max(0, meeting - ABOUT);
      double to = meeting + ABOUT;
      double reach = obstacle.reachAt(to) + margin + BEYOND;
      List<Cell> swept =
          new Disc(reach).cellsAlong(grid, obstacle.positionAt(from), obstacle.positionAt(to));
      for (Cell cell : swept) {
        if (grid.contains(cell)) {
          occupied.set(grid.index(cell));
        }
      }
    }
    return grid.withOccupied(occupied);
  }
}
