package org.toqa.lab.csm;

import static org.toqa.lab.csm.CsmParameters.LIMITS;
import static org.toqa.lab.csm.CsmParameters.PLANNED;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.avoidance.Encounter;
import org.toqa.avoidance.MovingDisc;
import org.toqa.avoidance.SafePace;
import org.toqa.driving.DetourPlanner;
import org.toqa.driving.DrivenLine;
import org.toqa.driving.LineSpeeds;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.lab.experiment.Run;
import org.toqa.motion.WheelCommand;

/**
 * A body that drives a line among discs that move: it looks ahead, takes a detour where it would
 * meet one, slows down where nothing else is safe, and goes on. Where it is, is what it answers, or
 * what ranges make of that.
 */
final class DynamicDrive {
  /** Metres: the radius of the robot; what is planned for is larger by its position error. */
  static final double BODY = 0.085;

  /** Metres that are kept from moving discs beyond the radius that is planned for. */
  private static final double MARGIN = 0.02;

  /** Metres a second of its faster wheel, below which the robot stands: its motors run out. */
  private static final double STANDING = 0.02;

  private static final double LONGEST = 60;

  /** Samples between two looks ahead. */
  private static final int LOOK = 5;

  /** The same while it stands: there the disc has to go first. */
  private static final int LOOK_STANDING = 20;

  private static final int SETTLING = 30;

  private final Run run;
  private final @Nullable RangedPose ranged;
  private final DetourPlanner detours;
  private final SafePace pace;
  private final TrackedDrive drive;
  private DrivenLine line;
  private LineSpeeds speeds;
  private List<MovingDisc> discs;
  private double metres;
  private double speed;
  private double last;
  private int detoursTaken;
  private int samplesStood;
  private boolean isTouchedWhileDriving;
  private boolean isTouchedWhileStanding;
  private double nearest = Double.POSITIVE_INFINITY;
  private final List<Double> planningMilliseconds = new ArrayList<>();

  /** By its answers alone, and judged by them. */
  DynamicDrive(CsmFloor floor, DrivenLine line, List<MovingDisc> discs, Run run, long seed) {
    this(floor, line, discs, run, seed, null);
  }

  /** With its pose corrected by ranges, and judged by where it is in truth. */
  static DynamicDrive withRanges(
      CsmFloor floor, DrivenLine line, List<MovingDisc> discs, Run run, long seed) {
    double noise = run.value(CsmParameters.RANGE_NOISE);
    RangedPose ranged =
        new RangedPose(line.at(0), floor.grid(), noise, new SplittableRandom(~seed));
    return new DynamicDrive(floor, line, discs, run, seed, ranged);
  }

  private DynamicDrive(
      CsmFloor floor,
      DrivenLine line,
      List<MovingDisc> discs,
      Run run,
      long seed,
      @Nullable RangedPose ranged) {
    this.run = run;
    this.ranged = ranged;
    this.line = line;
    this.discs = discs;
    double radius = run.value(CsmParameters.RADIUS);
    this.detours = new DetourPlanner(floor.grid(), radius, MARGIN, PLANNED, seed);
    this.pace = new SafePace(radius, PLANNED.acceleration(), WheelCommand.SAMPLE);
    this.speeds = new LineSpeeds(line, PLANNED);
    TwoWheelBody body =
        new TwoWheelBody(line.at(0), LIMITS, CsmParameters.faults(run), new SplittableRandom(seed));
    this.drive = new TrackedDrive(body, run.value(CsmParameters.DELAY), LIMITS, ranged);
  }

  /** Drives to the end of the line, or for a minute. */
  DynamicDrive drive() {
    int most = (int) (LONGEST / WheelCommand.SAMPLE);
    for (int sample = 0; sample < most && metres < line.length(); sample++) {
      run.checkStopped();
      if (sample % (speed > 0 ? LOOK : LOOK_STANDING) == 0) {
        lookAhead();
      }
      advance();
    }
    for (int i = 0; i < SETTLING; i++) {
      step(Twist.ZERO, Twist.ZERO);
    }
    return this;
  }

  private void lookAhead() {
    Optional<Encounter> meeting = detours.encounter(line, metres, speed, discs);
    if (meeting.isEmpty()) {
      return;
    }
    long begin = System.nanoTime();
    Optional<DrivenLine> other = detours.plan(line, metres, speed, meeting.get(), discs);
    planningMilliseconds.add((System.nanoTime() - begin) / 1e6);
    if (other.isPresent()) {
      line = other.get();
      speeds = new LineSpeeds(line, PLANNED);
      detoursTaken++;
    }
  }

  private void advance() {
    double before = metres;
    double wanted = speeds.next(metres, speed);
    speed = pace.next(ahead -> line.at(before + ahead).position(), speed, wanted, discs);
    samplesStood += speed == 0 ? 1 : 0;
    double driven = speed * WheelCommand.SAMPLE;
    // what comes is not known yet: it is taken to go on speeding up or braking as now
    double next = Math.max(0, 2 * speed - last);
    last = speed;
    step(twist(metres, speed), twist(metres + driven, next));
    metres += driven;
  }

  /** The line's own velocity at a place, at a speed. */
  private Twist twist(double at, double v) {
    double turn =
        Angles.difference(line.at(at).theta(), line.at(at + v * WheelCommand.SAMPLE).theta());
    return new Twist(v, 0, turn / WheelCommand.SAMPLE);
  }

  private void step(Twist twist, Twist then) {
    drive.step(line.at(metres), twist, then, discs);
    discs = discs.stream().map(disc -> disc.after(WheelCommand.SAMPLE)).toList();
    Pose at = ranged != null ? drive.body().truth() : drive.body().answer();
    boolean stands = drive.body().speed() < STANDING;
    for (MovingDisc disc : discs) {
      double gap = at.position().distanceTo(disc.position()) - BODY - disc.radius();
      nearest = Math.min(nearest, stands ? Double.POSITIVE_INFINITY : gap);
      isTouchedWhileDriving |= gap < 0 && !stands;
      isTouchedWhileStanding |= gap < 0 && stands;
    }
  }

  TrackedDrive tracked() {
    return drive;
  }

  /** The line with its detours. */
  DrivenLine line() {
    return line;
  }

  /** Where the robot was by its answers. */
  List<Vec2> answered() {
    return drive.samples().stream().map(sample -> sample.answered().position()).toList();
  }

  boolean hasArrived() {
    return metres >= line.length();
  }

  boolean isTouchedWhileDriving() {
    return isTouchedWhileDriving;
  }

  boolean isTouchedWhileStanding() {
    return isTouchedWhileStanding;
  }

  int detoursTaken() {
    return detoursTaken;
  }

  double secondsStood() {
    return samplesStood * WheelCommand.SAMPLE;
  }

  /** Metres by which the robot was in truth away from its reference, at most. */
  double trueError() {
    return drive.most(TrackedDrive.Sample::trueError);
  }

  /** How many of its ranges did not fit the map, of those of which it made something. */
  String refusedRanges() {
    RangedPose pose = ranged;
    return pose == null ? "-" : pose.refused() + " of " + (pose.used() + pose.refused());
  }

  /** Metres between the robot and the nearest disc, while it drove. */
  double nearest() {
    return nearest;
  }

  /** Of each look that led to planning. */
  List<Double> planningMilliseconds() {
    return planningMilliseconds;
  }
}
