package org.toqa.agent.chassis;

import static java.util.stream.Collectors.toSet;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.Fault;

/**
 * A body as it is.
 *
 * @param powerCycle another number after every power-up: odometry of two power cycles has nothing
 *     to do with each other
 * @param startPose where the body was at its power-up, map frame, if that is known for sure
 * @param odometry moved since power-up, in the frame of the pose that it had then
 * @param twist in the robot's frame
 * @param battery 0 to 1
 * @param ranges metres, in the order of the range sensors
 * @param faults why the body cannot drive; empty when it can
 * @param measuredLoad kilograms that it bears, as it measures; null: nothing, or it has no scale
 * @param progress on the path that it drives by itself; null while it drives none
 * @param camera what its cameras see; null: it has none, or they see nothing at all
 * @param stoppedItself whether one of the faults is a stop that the body made by itself, and ends
 *     by itself
 */
public record ChassisReading(
    long powerCycle,
    @Nullable Pose startPose,
    Pose odometry,
    Twist twist,
    double battery,
    List<Double> ranges,
    List<Fault> faults,
    @Nullable Double measuredLoad,
    @Nullable PathProgress progress,
    @Nullable CameraView camera,
    boolean stoppedItself) {

  /** Of a body without cameras. */
  public ChassisReading(
      long powerCycle,
      @Nullable Pose startPose,
      Pose odometry,
      Twist twist,
      double battery,
      List<Double> ranges,
      List<Fault> faults,
      @Nullable Double measuredLoad,
      @Nullable PathProgress progress) {
    this(
        powerCycle,
        startPose,
        odometry,
        twist,
        battery,
        ranges,
        faults,
        measuredLoad,
        progress,
        null,
        false);
  }

  public ChassisReading {
    ranges = List.copyOf(ranges);
    faults = List.copyOf(faults);
  }

  /** The same with these faults. */
  public ChassisReading withFaults(List<Fault> others) {
    return new ChassisReading(
        powerCycle,
        startPose,
        odometry,
        twist,
        battery,
        ranges,
        others,
        measuredLoad,
        progress,
        camera,
        stoppedItself);
  }

  /** The codes of the stops that only a person's word clears. */
  public Set<String> stops() {
    return faults.isEmpty() // at most ticks
        ? Set.of()
        : faults.stream().filter(Fault::clearable).map(Fault::code).collect(toSet());
  }

  /** Whether the body has made a stop that lasts: when it is over, nothing moves by itself. */
  public boolean hasOwnStop() {
    return stoppedItself || !stops().isEmpty();
  }

  /** Within what its encoders can tell. */
  public boolean isStanding() {
    return Math.hypot(twist.vx(), twist.vy()) < 0.01 && Math.abs(twist.w()) < 0.05;
  }
}
