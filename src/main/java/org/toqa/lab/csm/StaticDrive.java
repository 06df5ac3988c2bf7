package org.toqa.lab.csm;

import static org.toqa.lab.csm.CsmParameters.LIMITS;

import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.driving.DrivenLine;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.lab.experiment.Run;
import org.toqa.motion.ArcLength;
import org.toqa.motion.WheelCommand;
import org.toqa.motion.WheelSchedule;

/**
 * Curves that a body drives from rest to rest, by their wheel schedule, and again with its pose
 * corrected by ranges.
 *
 * @param name for tables
 * @param desired metres along the curves
 * @param drive by its answers alone
 * @param ranged the same with ranges
 * @param aside the most metres that the robot was beside the curves, by its answers
 */
record StaticDrive(
    String name, double desired, TrackedDrive drive, TrackedDrive ranged, double aside) {

  /** Drives them on a floor, beginning in their direction. */
  static StaticDrive of(
      String name, List<? extends PlaneCurve> curves, CsmFloor floor, Run run, long seed) {
    Vec2 from = curves.getFirst().position(0);
    double heading = curves.getFirst().velocity(0).angle();
    double last = curves.getLast().velocity(curves.getLast().end()).angle();
    WheelSchedule schedule = WheelSchedule.of(heading, curves, last, CsmParameters.PLANNED);
    Pose start = new Pose(from.x(), from.y(), heading);
    double noise = run.value(CsmParameters.RANGE_NOISE);
    RangedPose pose = new RangedPose(start, floor.grid(), noise, new SplittableRandom(~seed));
    TrackedDrive drive = drive(schedule, start, run, seed, null);
    TrackedDrive ranged = drive(schedule, start, run, seed, pose);
    double length = curves.stream().mapToDouble(curve -> new ArcLength(curve).total()).sum();
    DrivenLine line = DrivenLine.of(curves);
    double aside = drive.most(sample -> line.distanceTo(sample.answered().position()));
    return new StaticDrive(name, length, drive, ranged, aside);
  }

  private static TrackedDrive drive(
      WheelSchedule schedule, Pose start, Run run, long seed, @Nullable RangedPose pose) {
    TwoWheelBody body =
        new TwoWheelBody(start, LIMITS, CsmParameters.faults(run), new SplittableRandom(seed));
    double delay = run.value(CsmParameters.DELAY);
    return TrackedDrive.of(schedule, start, body, delay, LIMITS, pose);
  }

  /** Metres driven, by the answers. */
  double actual() {
    return drive.length(TrackedDrive.Sample::answered);
  }

  /** Metres. */
  double positionError() {
    return drive.most(TrackedDrive.Sample::positionError);
  }

  /** Radians. */
  double orientationError() {
    return drive.most(TrackedDrive.Sample::orientationError);
  }

  /** Metres by which the robot was in truth away from its reference. */
  double trueError() {
    return drive.most(TrackedDrive.Sample::trueError);
  }

  /** The same where ranges correct its pose. */
  double trueErrorWithRanges() {
    return ranged.most(TrackedDrive.Sample::trueError);
  }

  /** Metres a second, of the faster wheel. */
  double wheelSpeed() {
    return drive.most(s -> Math.max(speed(s.command().left()), speed(s.command().right())));
  }

  private static double speed(WheelCommand.Wheel wheel) {
    return Math.abs(wheel.speed());
  }

  double amplitude() {
    return drive.most(
        s -> Math.max(s.command().left().amplitude(), s.command().right().amplitude()));
  }

  /** Milliseconds. */
  double pulse() {
    return drive.most(
        s ->
            Math.max(
                s.command().left().pulseMilliseconds(), s.command().right().pulseMilliseconds()));
  }

  /** Milliseconds of T_on, which is within a sample. */
  double on() {
    return drive.most(
        s -> 1000 * Math.max(s.command().left().onSeconds(), s.command().right().onSeconds()));
  }
}
