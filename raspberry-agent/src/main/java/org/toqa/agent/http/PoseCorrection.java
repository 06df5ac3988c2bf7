package org.toqa.agent.http;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.http.RobotDescription;
import org.toqa.localisation.PoseEstimate;
import org.toqa.localisation.RangeFilter;
import org.toqa.localisation.RangeSource;

/**
 * Corrects the odometry of a robot over HTTP by the ultrasonic ranges that it publishes ({@link
 * RangeFilter}). It begins where a person says that the robot stands, and knows when what is
 * measured no longer fits that. For one thread.
 */
final class PoseCorrection {
  /** Metres, radians: how exactly a person says where a robot stands. */
  private static final double PLACED = 0.03;

  /** Seconds by which ranges may be older than wheel counts: they come on another way. */
  private static final double LATE = 0.1;

  /** Metres driven, and ranges judged, over which it is found out whether they fit the map. */
  private static final double JUDGED_OVER = 0.5;

  private static final int LEAST_JUDGED = 20;

  /** Of those, who has so many that do not fit has lost itself. */
  private static final double MOST_REFUSED = 0.75;

  private final RangeSource source;
  private final double deviation;
  private final double radius;
  private final RangeFilter filter;

  /** The map's pose of the origin of the odometry; null: nobody knows. */
  private @Nullable Pose anchor;

  private @Nullable PoseEstimate estimate;
  private Pose before = new Pose(0, 0, 0);

  /** Since it was last found out whether ranges fit. */
  private double driven;

  private int used;
  private int refused;
  private boolean isLost;

  PoseCorrection(RangeSource source, RobotDescription body, RobotDescription.Sonar sonar) {
    this.source = source;
    this.deviation = sonar.deviation();
    this.radius = body.footprint() / 2;
    this.filter = new RangeFilter(RangeFilter.Body.withSonar(body.track(), sonar.farthest()));
  }

  /** Takes where the map has the origin of the odometry. */
  void setAnchor(@Nullable Pose now) {
    if (now == null || !now.equals(anchor)) {
      anchor = now;
      estimate = null;
      isLost = false;
      restartJudging();
    }
  }

  /**
   * Goes on with what the wheels have turned, and takes ranges if there are new ones.
   *
   * @param odometry where the body is now by its wheels, in their frame
   * @param twist by which it moves, robot frame
   * @return where it is taken to be, in the same frame; empty where ranges change nothing
   */
  Optional<Pose> correct(Pose odometry, Twist twist) {
    Pose origin = anchor;
    if (origin == null) {
      return Optional.empty();
    }
    PoseEstimate known = estimate;
    PoseEstimate now =
        known == null
            ? PoseEstimate.of(origin.compose(odometry), PLACED, PLACED)
            : filter.moved(known, before, odometry);
    estimate = now;
    driven += known == null ? 0 : before.distanceTo(odometry);
    before = odometry;
    return source.take().flatMap(measured -> corrected(origin, now, measured, twist));
  }

  private Optional<Pose> corrected(
      Pose origin, PoseEstimate now, RangeSource.Measured measured, Twist twist) {
    RangeFilter.Correction correction =
        filter.corrected(now, ranges(measured, twist), measured.walls());
    used += correction.used();
    refused += correction.refused() + correction.missed();
    judge();
    if (correction.used() == 0) {
      return Optional.empty();
    }
    Pose corrected = origin.relative(correction.estimate().pose());
    estimate = correction.estimate();
    before = corrected;
    return Optional.of(corrected);
  }

  /** Whether most of what was measured fits no longer the map where it is taken to be. */
  boolean isLost() {
    return isLost;
  }

  private void judge() {
    int judged = used + refused;
    if (driven >= JUDGED_OVER && judged >= LEAST_JUDGED) {
      isLost = refused >= MOST_REFUSED * judged;
      restartJudging();
    }
  }

  private void restartJudging() {
    driven = 0;
    used = 0;
    refused = 0;
  }

  private List<RangeFilter.Range> ranges(RangeSource.Measured measured, Twist twist) {
    List<RangeFilter.Range> ranges = new ArrayList<>();
    for (int i = 0; i < measured.metres().size(); i++) {
      double metres = measured.metres().get(i);
      double angle = measured.angles().get(i);
      // what it moves and turns past while a range is on its way
      double moved = LATE * Math.hypot(Math.hypot(twist.vx(), twist.vy()), metres * twist.w());
      ranges.add(
          new RangeFilter.Range(
              new Pose(radius * Math.cos(angle), radius * Math.sin(angle), angle),
              metres,
              Math.hypot(deviation, moved)));
    }
    return ranges;
  }
}
