package org.toqa.app.plan;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.motion.BiarcFitter;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Trajectory;
import org.toqa.motion.WheelSchedule;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.WayPath;
import org.toqa.planning.smooth.curve.CubicSpline;
import org.toqa.planning.smooth.curve.PolynomialCurve;
import org.toqa.planning.smooth.curve.PolynomialFitter;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

/**
 * A smooth curve on a map, and how robots drive it.
 *
 * @param floor the map as it was read
 * @param space of the disc that it was planned for
 * @param curve metres, map frame
 * @param trajectory the same as segments, for robots of the ordinary link
 * @param schedule the same for two wheels, in samples of 30 ms
 * @param polynomial the paper's y(x) through the same way points; null where none is free
 */
record SmoothDrive(
    FloorMap floor,
    DiscSpace space,
    SmoothCurve curve,
    Trajectory trajectory,
    WheelSchedule schedule,
    @Nullable PolynomialCurve polynomial) {

  /** Metres between points of the curve that are drawn or printed, at most. */
  private static final double APART = 0.01;

  /** Cells between them, at most: no wall is between two of them. */
  private static final double CELLS_APART = 0.5;

  /** Cells that segments may be beside the curve, at most. */
  private static final double CELLS_BESIDE = 0.02;

  /**
   * Fits the curve and plans its speeds.
   *
   * @param start heading, radians, counter-clockwise from map east; null for that of the curve
   */
  static SmoothDrive of(FloorMap floor, DiscSpace space, WayPath path, @Nullable Double start) {
    SmoothCurve curve = new SplineFitter(space).fit(path.points(), start, null);
    double first = curve.pieces().isEmpty() ? 0 : curve.pieces().getFirst().velocity(0).angle();
    double heading = start == null ? first : start;
    double last = heading;
    for (CubicSpline piece : curve.pieces()) {
      last = piece.velocity(piece.end()).angle();
    }
    double cell = floor.grid().resolution();
    double beside = Math.min(BiarcFitter.USUAL_TOLERANCE, CELLS_BESIDE * cell);
    Trajectory fitted = new BiarcFitter(DriveSpeeds.DEFAULT, beside).fit(heading, curve.pieces());
    Vec2 from = path.points().getFirst();
    return new SmoothDrive(
        floor,
        space,
        curve,
        new Trajectory(new Pose(from.x(), from.y(), heading), fitted.segments()),
        WheelSchedule.of(heading, curve.pieces(), last, DifferentialLimits.DEFAULT),
        new PolynomialFitter(space).fit(path.points()).orElse(null));
  }

  /** Points of the curve, to be drawn or printed. */
  List<Vec2> points() {
    return curve.points(Math.min(APART, CELLS_APART * floor.grid().resolution()));
  }

  /** Between curves; one at the start is not counted. */
  int turnsOnSpot() {
    return Math.max(0, curve.pieces().size() - 1);
  }
}
