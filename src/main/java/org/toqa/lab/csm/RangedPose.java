package org.toqa.lab.csm;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.toqa.avoidance.MovingDisc;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.localisation.GridWalls;
import org.toqa.localisation.PoseEstimate;
import org.toqa.localisation.RangeFilter;
import org.toqa.localisation.Walls;

/**
 * Where a body is by its answers, corrected by four ultrasonic sensors on its rim that look ahead,
 * to both sides and back, ten times a second, and tell what they measured with the answer of that
 * sample. What they measure is simulated here: walls, discs that move, and noise.
 */
final class RangedPose {
  private static final List<Pose> BEAMS =
      Stream.of(-0.5, 0.0, 0.5, 1.0)
          .map(turns -> turns * Math.PI)
          .map(
              angle ->
                  new Pose(
                      DynamicDrive.BODY * Math.cos(angle),
                      DynamicDrive.BODY * Math.sin(angle),
                      angle))
          .toList();

  /** Metres: as HC-SR04. */
  private static final double NEAREST = 0.02;

  private static final double FARTHEST = 4;

  /** Metres, radians: how exactly a robot is put on its start. */
  private static final double PLACED = 0.005;

  /** Samples from one measurement to the next, 0.09 s. */
  private static final int PERIOD = 3;

  private final Walls walls;
  private final double noise;
  private final RandomGenerator random;
  private final RangeFilter filter;
  private PoseEstimate estimate;
  private Pose answered;
  private int used;
  private int refused;

  /** Of each sample so far. */
  private final List<Pose> poses = new ArrayList<>();

  RangedPose(Pose start, OccupancyGrid grid, double noise, RandomGenerator random) {
    this.walls = new GridWalls(grid);
    this.noise = noise;
    this.random = random;
    this.filter =
        new RangeFilter(RangeFilter.Body.withSonar(CsmParameters.LIMITS.track(), FARTHEST));
    this.estimate = PoseEstimate.of(start, PLACED, PLACED);
    this.answered = start;
  }

  /**
   * Takes the next sample.
   *
   * @param answer where the body is by its wheels
   * @param truth where it is
   * @param discs where others are then
   */
  void add(Pose answer, Pose truth, List<MovingDisc> discs) {
    estimate = filter.moved(estimate, answered, answer);
    answered = answer;
    if (poses.size() % PERIOD == 0) {
      RangeFilter.Correction correction =
          filter.corrected(
              estimate,
              BEAMS.stream()
                  .map(beam -> new RangeFilter.Range(beam, range(truth, beam, discs), noise))
                  .toList(),
              walls);
      estimate = correction.estimate();
      used += correction.used();
      refused += correction.refused();
    }
    poses.add(estimate.pose());
  }

  private double range(Pose truth, Pose beam, List<MovingDisc> discs) {
    Pose ray = truth.compose(beam);
    double nearest = walls.hit(ray, FARTHEST).map(Walls.Hit::distance).orElse(FARTHEST);
    for (MovingDisc disc : discs) {
      nearest = Math.min(nearest, distance(ray, disc));
    }
    return Math.clamp(nearest + noise * random.nextGaussian(), NEAREST, FARTHEST);
  }

  /** Metres along a ray to a disc; infinite where it passes beside it. */
  private static double distance(Pose ray, MovingDisc disc) {
    Vec2 centre = disc.position().minus(ray.position()).rotated(-ray.theta());
    double half = Math.sqrt(disc.radius() * disc.radius() - centre.y() * centre.y());
    return centre.x() > 0 && half >= 0 ? Math.max(0, centre.x() - half) : Double.POSITIVE_INFINITY;
  }

  /** Where it was taken to be in a sample that was added. */
  Pose pose(int sample) {
    return poses.get(sample);
  }

  /** Ranges that were believed. */
  int used() {
    return used;
  }

  /** Ranges that did not fit. */
  int refused() {
    return refused;
  }
}
