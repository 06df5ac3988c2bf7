package org.toqa.agent.chassis;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;

/** The range sensors of a simulated body: a new reading every 40 ms, with noise. */
final class SimulatedRangeSensors {

  /** A position-sensitive detector of this range measures for 38 ms. */
  private static final long PERIOD_NANOS = 40_000_000;

  /** Assumed: standard deviation, as a share of the distance. */
  private static final double NOISE = 0.005;

  private final List<Pose> beams;
  private final Surroundings surroundings;
  private final SplittableRandom random;
  private final BitSet blind = new BitSet();
  private List<Double> ranges = List.of();
  private long nextNanos = Long.MIN_VALUE;

  SimulatedRangeSensors(RangeSensors sensors, Surroundings surroundings, long seed) {
    this.beams = sensors.beams();
    this.surroundings = surroundings;
    this.random = new SplittableRandom(seed);
  }

  /**
   * @param truth of the body, map frame
   * @return metres, from right to left
   */
  List<Double> update(Pose truth, long nanos) {
    if (nanos >= nextNanos) {
      nextNanos = nanos + PERIOD_NANOS;
      List<Double> now = new ArrayList<>();
      for (int i = 0; i < beams.size(); i++) {
        now.add(blind.get(i) ? RangeSensors.FARTHEST : range(truth.compose(beams.get(i))));
      }
      ranges = List.copyOf(now);
    }
    return ranges;
  }

  void setBlind(int sensor, boolean isBlind) {
    blind.set(sensor, isBlind);
  }

  private double range(Pose beam) {
    double distance = surroundings.distance(beam, RangeSensors.FARTHEST);
    return distance >= RangeSensors.FARTHEST
        ? RangeSensors.FARTHEST
        : Math.clamp(
            distance * (1 + NOISE * random.nextGaussian()),
            RangeSensors.NEAREST,
            RangeSensors.FARTHEST);
  }
}
