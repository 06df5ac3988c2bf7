package org.toqa.formation;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * Which trajectories a shape can be led along (Tanta, "Formation control", geometry): no turn on
 * the spot, no circle tighter than the shape allows, and no robot of it faster than it can be.
 */
public final class TrajectoryRules {

  private static final double ROUNDING = 1e-9;

  private final Shape shape;
  private final double mostSpeed;

  /**
   * @param mostSpeed metres a second, of the slowest of the robots
   */
  public TrajectoryRules(Shape shape, double mostSpeed) {
    if (!(mostSpeed > 0)) {
      throw new IllegalArgumentException("A speed is more than 0 m/s, not " + mostSpeed + ".");
    }
    this.shape = shape;
    this.mostSpeed = mostSpeed;
  }

  /** What is wrong with a trajectory. */
  public enum Fault {
    TURN_ON_THE_SPOT,
    BACKWARDS,
    SIDEWAYS,
    TOO_TIGHT
  }

  /**
   * @param segment the first one that breaks a rule
   */
  public record Breach(Fault fault, int segment) {}

  /** The first breach of a rule about the trajectory's geometry. */
  public Optional<Breach> firstBreach(Trajectory leaderTrajectory) {
    List<Segment> segments = leaderTrajectory.segments();
    return IntStream.range(0, segments.size())
        .boxed()
        .flatMap(i -> faultOf(segments.get(i)).map(fault -> new Breach(fault, i)).stream())
        .findFirst();
  }

  private Optional<Fault> faultOf(Segment segment) {
    if (segment.v() < 0) {
      return Optional.of(Fault.BACKWARDS);
    }
    if (segment.shifts() && !shape.mobility().canShift()) {
      return Optional.of(Fault.SIDEWAYS);
    }
    if (segment.w() == 0) {
      return Optional.empty();
    }
    double radius = segment.v() / Math.abs(segment.w());
    if (radius == 0) {
      return Optional.of(Fault.TURN_ON_THE_SPOT);
    }
    return radius < shape.smallestRadius() - ROUNDING
        ? Optional.of(Fault.TOO_TIGHT)
        : Optional.empty();
  }

  /** The same trajectory, driven so slowly that no robot is faster than it can be. */
  public Trajectory slowed(Trajectory leaderTrajectory) {
    return new Trajectory(
        leaderTrajectory.start(), leaderTrajectory.segments().stream().map(this::slowed).toList());
  }

  private Segment slowed(Segment segment) {
    double share = Math.min(1, mostSpeed / fastestRobotSpeed(segment.twist()));
    return segment.slowed(share);
  }

  // at lateral offset d on an arc of radius R: v (R + d) / R
  private double fastestRobotSpeed(Twist leader) {
    return Stream.concat(Stream.of(Vec2.ZERO), shape.offsets().stream())
        .map(offset -> RigidMotion.at(offset, leader))
        .mapToDouble(twist -> Math.hypot(twist.vx(), twist.vy()))
        .max()
        .orElseThrow();
  }

  /**
   * How long a corner of a trajectory must be, so that its arc is not too tight: with L the length
   * of {@link org.toqa.motion.SegmentFitter}, R = (L/2) / tan(angle/2).
   *
   * @param angle of the sharpest corner, radians
   * @return L, metres
   */
  public double cornerLength(double angle) {
    return 2 * shape.smallestRadius() * Math.tan(Math.abs(angle) / 2);
  }
}
