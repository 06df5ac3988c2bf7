package org.toqa.app.plan;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;
import org.toqa.motion.WheelCommand;
import org.toqa.planning.smooth.SmoothResult.Reason;
import org.toqa.planning.smooth.curve.PolynomialCurve;
import tools.jackson.databind.json.JsonMapper;

/**
 * A smooth curve for programs.
 *
 * @param reason why there is no path; null where there is one
 * @param length metres along the curve
 * @param seconds that two wheels take for it
 * @param maxCurvature radians a metre
 * @param turnsOnSpot how often the robot turns on the spot between start and goal
 * @param start pose at the start of the first segment; metres and radians, map frame
 * @param path points of the curve, metres, map frame
 * @param segments v in metres a second, w in radians a second, positive to the left, t in seconds
 * @param wheels samples of 30 ms
 * @param polynomial from and to in metres, map frame, and bulge, as {@link PolynomialCurve} has
 *     them; null where none is free
 */
record SmoothJson(
    boolean found,
    @Nullable Reason reason,
    @Nullable Double length,
    @Nullable Double seconds,
    @Nullable Double maxCurvature,
    @Nullable Integer turnsOnSpot,
    @Nullable Pose start,
    List<double[]> path,
    List<Segment> segments,
    List<WheelCommand> wheels,
    @Nullable PolynomialCurve polynomial) {

  static String of(SmoothDrive drive) {
    return text(
        new SmoothJson(
            true,
            null,
            drive.curve().length(),
            drive.schedule().duration(),
            drive.curve().maxCurvature(),
            drive.turnsOnSpot(),
            drive.trajectory().start(),
            drive.points().stream().map(point -> new double[] {point.x(), point.y()}).toList(),
            drive.trajectory().segments(),
            drive.schedule().commands(),
            drive.polynomial()));
  }

  static String of(Reason reason) {
    return text(
        new SmoothJson(
            false, reason, null, null, null, null, null, List.of(), List.of(), List.of(), null));
  }

  private static String text(SmoothJson plan) {
    return JsonMapper.shared().writeValueAsString(plan);
  }
}
