package org.toqa.localisation;

import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.localisation.PoseEstimate.Slope;
import org.toqa.localisation.Walls.Hit;

/**
 * Corrects where a robot on two wheels takes itself to be by ranges to the walls of its map: an
 * extended Kalman filter on x, y and heading (J. J. Leonard and H. F. Durrant-Whyte, "Mobile robot
 * localization by tracking geometric beacons", IEEE Transactions on Robotics and Automation 7(3),
 * 1991), whose beacons are the faces that rays meet on the exact map. Each range is a measurement
 * of its own, so no matrix is inverted; one costs three rays and some forty operations.
 *
 * <ol>
 *   <li>{@link #moved} is told every step of the wheels.
 *   <li>{@link #corrected} is told what the sensors measured there.
 * </ol>
 *
 * <p>Not believed is what does not fit: a range farther from what is expected than three standard
 * deviations of both (their validation gate), as of somebody who stands before a wall. Nothing is
 * made of a range whose face is met at a slant, where sound goes elsewhere, or lies so near an edge
 * that another face may have been meant, nor of one that reads nothing, but for that it did. And
 * who hardly knows where he is takes no range for one of a wall: he may be before another one.
 */
public final class RangeFilter {

  /** Standard deviations of what is measured and expected. */
  private static final double GATE = 3;

  /** Of the angle between ray and face: at most 60 degrees off the square. */
  private static final double LEAST_COSINE = 0.5;

  /** Standard deviations within which the face must be the same one. */
  private static final double SAME_FACE = 2;

  /** Radians that are added to that: a beam has a width. */
  private static final double BEAM_WIDTH = Math.toRadians(1);

  /** Metres between two planes that are one. */
  private static final double SAME_PLANE = 1e-4;

  /** Metres, radians: who knows less than that is not corrected. */
  private static final double MOST_UNCERTAIN = 0.15;

  /**
   * Metres: however often a robot that stands measures the same walls, it does so with the same
   * errors of map and sensors.
   */
  private static final double SUREST_PLACE = 0.002;

  /** Radians, likewise: walls that are met squarely tell nothing of a heading. */
  private static final double SUREST_HEADING = 0.01;

  private final Body body;

  /**
   * What is known of the robot.
   *
   * @param track metres between the wheels
   * @param travelNoise variance of what a wheel rolls, for each metre; metres
   * @param nearest metres: sensors tell what is nearer as this
   * @param farthest metres: sensors tell as this, or more, that they see nothing
   */
  public record Body(double track, double travelNoise, double nearest, double farthest) {

    /** Metres: the variance of a metre that a wheel rolls is 1 cm2. */
    private static final double TRAVEL_NOISE = 1e-4;

    /** Metres: ultrasonic sensors ring on while something is nearer. */
    private static final double NEAREST = 0.02;

    /** Of a robot with ultrasonic sensors. */
    public static Body withSonar(double track, double farthest) {
      return new Body(track, TRAVEL_NOISE, NEAREST, farthest);
    }
  }

  /**
   * What a sensor measured.
   *
   * @param beam where it is and looks, in the robot's frame
   * @param metres that it read
   * @param deviation of that from the truth and of the map from the floor, standard, metres
   */
  public record Range(Pose beam, double metres, double deviation) {}

  /**
   * What ranges made of an estimate.
   *
   * @param used how many were believed
   * @param refused how many did not fit
   * @param missed how many saw nothing where a wall was expected
   */
  public record Correction(PoseEstimate estimate, int used, int refused, int missed) {}

  public RangeFilter(Body body) {
    this.body = body;
  }

  /**
   * After a step by odometry.
   *
   * @param before where its odometry had the robot, in any frame
   * @param after where it has it now, in the same one; it has not turned by half since
   */
  public PoseEstimate moved(PoseEstimate estimate, Pose before, Pose after) {
    return estimate.moved(before.relative(after), body.track(), body.travelNoise());
  }

  /** With what the sensors measured there. */
  public Correction corrected(PoseEstimate estimate, List<Range> ranges, Walls walls) {
    PoseEstimate now = estimate;
    int used = 0;
    int refused = 0;
    int missed = 0;
    for (Range range : ranges) {
      Optional<Hit> hit = face(now, range, walls);
      if (hit.isEmpty()) {
        continue;
      }
      Slope slope = slope(now.pose(), range.beam(), hit.get());
      double variance = range.deviation() * range.deviation();
      double innovation = range.metres() - hit.get().distance();
      double gate = GATE * Math.sqrt(now.variance(slope) + variance);
      if (range.metres() >= body.farthest()) {
        missed += hit.get().distance() + gate < body.farthest() ? 1 : 0;
      } else if (Math.abs(innovation) > gate) {
        refused++;
      } else {
        now = now.corrected(slope, innovation, variance);
        used++;
      }
    }
    return new Correction(
        used == 0 ? now : now.noSurerThan(SUREST_PLACE, SUREST_HEADING), used, refused, missed);
  }

  /** The face that a range is expected to be of; empty where it would tell nothing. */
  private Optional<Hit> face(PoseEstimate estimate, Range range, Walls walls) {
    if (range.metres() <= body.nearest()
        || estimate.positionDeviation() > MOST_UNCERTAIN
        || estimate.headingDeviation() > MOST_UNCERTAIN) {
      return Optional.empty();
    }
    Pose ray = estimate.pose().compose(range.beam());
    Optional<Hit> met = walls.hit(ray, body.farthest());
    if (met.isEmpty() || -dot(direction(ray.theta()), met.get().normal()) < LEAST_COSINE) {
      return Optional.empty();
    }
    double aside =
        BEAM_WIDTH
            + SAME_FACE
                * Math.hypot(
                    estimate.headingDeviation(),
                    estimate.positionDeviation() / met.get().distance());
    return isSame(ray, met.get(), walls, aside) && isSame(ray, met.get(), walls, -aside)
        ? met
        : Optional.empty();
  }

  /** Whether a ray that is turned by an angle meets the same plane. */
  private boolean isSame(Pose ray, Hit met, Walls walls, double angle) {
    Pose turned = new Pose(ray.x(), ray.y(), ray.theta() + angle);
    Optional<Hit> other = walls.hit(turned, 2 * body.farthest());
    return other.isPresent()
        && other.get().normal().equals(met.normal())
        && Math.abs(plane(turned, other.get()) - plane(ray, met)) < SAME_PLANE;
  }

  /** How far the ray's face lies behind the ray's beginning, metres. */
  private static double plane(Pose ray, Hit hit) {
    return hit.distance() * dot(direction(ray.theta()), hit.normal());
  }

  private static double dot(Vec2 a, Vec2 b) {
    return a.x() * b.x() + a.y() * b.y();
  }

  private static Vec2 direction(double angle) {
    return new Vec2(Math.cos(angle), Math.sin(angle));
  }

  /** How an expected range changes with where the robot is: of the ray p + r u on n (q - p) = 0. */
  private static Slope slope(Pose robot, Pose beam, Hit hit) {
    // r = n (q - p) / (n u):  dr/dp = -n / (n u),  dr/d(angle of u) = -r (n u') / (n u)
    Vec2 n = hit.normal();
    double angle = robot.theta() + beam.theta();
    double square = dot(n, direction(angle));
    Vec2 arm = beam.position().rotated(robot.theta());
    double swing = dot(n, new Vec2(-arm.y(), arm.x()));
    double turn = hit.distance() * dot(n, direction(angle + Math.PI / 2));
    return new Slope(-n.x() / square, -n.y() / square, -(swing + turn) / square);
  }
}
