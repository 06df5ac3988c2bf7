package org.toqa.fleet;

import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.formation.GroupMobility;
import org.toqa.motion.DriveKind;
import org.toqa.motion.DriveSpeeds;

/**
 * What a robot says that it can.
 *
 * @param footprint diameter, metres
 * @param maxLoad kilograms that it says it carries
 * @param sensorRange metres that its range sensors see
 * @param kind how it can move
 * @param track metres between its two wheels; 0: it has others, or nobody knows
 * @param arm null: it has none, or it is not known
 * @param findsOwnWay whether it finds its own way through free zones
 * @param knowsShifts whether it drives segments that go sideways, and follows a leader that does
 */
public record RobotCapabilities(
    double footprint,
    DriveSpeeds speeds,
    double maxLoad,
    double sensorRange,
    DriveKind kind,
    double track,
    @Nullable Arm arm,
    boolean findsOwnWay,
    boolean knowsShifts) {

  /** Of a robot that follows its path through free zones too, and knows no shifts. */
  public RobotCapabilities(
      double footprint,
      DriveSpeeds speeds,
      double maxLoad,
      double sensorRange,
      DriveKind kind,
      double track,
      @Nullable Arm arm) {
    this(footprint, speeds, maxLoad, sensorRange, kind, track, arm, false, false);
  }

  /** Of a robot without an arm. */
  public RobotCapabilities(
      double footprint,
      DriveSpeeds speeds,
      double maxLoad,
      double sensorRange,
      DriveKind kind,
      double track) {
    this(footprint, speeds, maxLoad, sensorRange, kind, track, null);
  }

  /** Assumed of a robot that was never heard of: the smallest diameter of ours, any load. */
  public static final RobotCapabilities UNKNOWN =
      new RobotCapabilities(
          0.255, DriveSpeeds.DEFAULT, Double.MAX_VALUE, 0.8, DriveKind.OMNI, 0, null, false, true);

  /** Of a robot of which nobody knows how far its wheels are apart. */
  public RobotCapabilities(
      double footprint, DriveSpeeds speeds, double maxLoad, double sensorRange, DriveKind kind) {
    this(footprint, speeds, maxLoad, sensorRange, kind, 0);
  }

  /** How it can move, in a word for programs. */
  public String kindWord() {
    return kind.word();
  }

  public RobotCapabilities withFootprint(double diameter) {
    return new RobotCapabilities(
        diameter, speeds, maxLoad, sensorRange, kind, track, arm, findsOwnWay, knowsShifts);
  }

  public RobotCapabilities withMaxLoad(double kilograms) {
    return new RobotCapabilities(
        footprint, speeds, kilograms, sensorRange, kind, track, arm, findsOwnWay, knowsShifts);
  }

  /** How a group with it can be led. */
  public GroupMobility mobility() {
    return GroupMobility.of(kind.canGoSideways(), knowsShifts);
  }

  /** Whether the robot has ever said what it carries: whether it was ever connected. */
  public boolean isLoadKnown() {
    return maxLoad < Double.MAX_VALUE;
  }

  /** Kilograms that the robot may carry: no more than it says, and than a person entered. */
  public double allowedLoad(RobotRecord robot) {
    return Math.min(robot.maxLoad(), maxLoad);
  }
}
