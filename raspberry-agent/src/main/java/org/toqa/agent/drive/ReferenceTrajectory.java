package org.toqa.agent.drive;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Segment;

/**
 * The segments of a drive as a moving reference: a pose that runs over the released ones at a pace
 * between 0 (stopped) and 1 (as planned).
 *
 * <p>Slowing down scales time and not the path, so that a robot that brakes stays on the curve that
 * was planned and checked. The pace rises and falls with the acceleration limits; before the end of
 * what is released, and before a corner where the velocity jumps, it falls in time: with braking
 * rate a and planned time T left to a place where the pace may be p, the pace P of the next tick is
 * as high as P^2 = p^2 + 2 a (T - P tick) allows (the look-ahead of machine-tool controllers, with
 * a junction limit as in grbl).
 */
public final class ReferenceTrajectory {

  /** Paces a second at most, also for segments that only wait. */
  private static final double MAX_PACE_RATE = 10;

  /** Seconds; a segment with less than this left is completed. */
  private static final double COMPLETED_SECONDS = 1e-6;

  /** Metres of an arc that are taken for straight: at a radius of 0.15 m it rises 0.3 mm. */
  private static final double PIECE_METRES = 0.02;

  private final List<Segment> segments = new ArrayList<>();
  private PaceLimits limits;
  private int releasedCount;
  private double paceRate = MAX_PACE_RATE;

  private int completedCount;
  private Pose segmentStart;
  private double timeInSegment;
  private double pace;

  /** Metres that it may still go, whatever is released. */
  private double stopDistance = Double.POSITIVE_INFINITY;

  public ReferenceTrajectory(Pose start, List<Segment> segments, int released, PaceLimits limits) {
    this.limits = limits;
    this.segmentStart = start;
    replace(0, segments, released);
  }

  /**
   * Replaces the segments with index {@code from} and above, none of which was released.
   *
   * @param from 0 for the first segment of the drive
   * @param nowReleased how many segments of the drive may be driven then
   */
  public void replace(int from, List<Segment> tail, int nowReleased) {
    segments.subList(from, segments.size()).clear();
    segments.addAll(tail);
    releasedCount = nowReleased;
    updatePaceRate();
  }

  /** From now on its velocity changes no more abruptly than this. */
  public void setLimits(PaceLimits newLimits) {
    if (!limits.equals(newLimits)) {
      limits = newLimits;
      updatePaceRate();
    }
  }

  private void updatePaceRate() {
    paceRate = segments.stream().mapToDouble(this::maxPaceRate).min().orElse(MAX_PACE_RATE);
  }

  /**
   * From now on the reference runs up to the end of so many segments.
   *
   * @param count of all segments from the first; no fewer than now
   */
  public void release(int count) {
    releasedCount = count;
  }

  /**
   * Moves the reference to where another one runs along the same segments.
   *
   * @param completed how many segments that one has left behind; no fewer than this one, and none
   *     that is not released
   * @param seconds of the next one's planned time
   * @param newPace as a share of the planned speed, 0 to 1
   */
  public void setProgress(int completed, double seconds, double newPace) {
    int reached = Math.min(completed, releasedCount);
    while (completedCount < reached) {
      leaveSegment();
    }
    boolean hasNext = completedCount < releasedCount;
    timeInSegment = hasNext ? Math.min(seconds, segments.get(completedCount).t()) : 0;
    pace = hasNext ? newPace : 0;
  }

  private void leaveSegment() {
    Segment done = segments.get(completedCount);
    segmentStart = segmentStart.advanced(done.twist(), done.t());
    timeInSegment = 0;
    completedCount++;
  }

  /**
   * From now on it stops within so many metres; turns on the spot are none. Where that is too short
   * to slow down, it stops at once.
   */
  void stopWithin(double metres) {
    stopDistance = metres;
  }

  /**
   * The released path from here on, as poses of which each follows from the one before on a
   * straight line, or nearly so.
   *
   * @param metres how far
   */
  List<Pose> posesAhead(double metres) {
    List<Pose> poses = new ArrayList<>();
    poses.add(pose());
    Pose start = segmentStart;
    double from = timeInSegment;
    double left = metres;
    for (int i = completedCount; i < releasedCount && left > 0; i++) {
      Segment segment = segments.get(i);
      if (segment.speed() != 0) {
        double length = Math.min(left, segment.speed() * (segment.t() - from));
        int pieces = segment.w() == 0 ? 1 : (int) Math.ceil(length / PIECE_METRES);
        for (int piece = 1; piece <= pieces; piece++) {
          double metresIn = length * piece / pieces;
          poses.add(start.advanced(segment.twist(), from + metresIn / segment.speed()));
        }
        left -= length;
      }
      start = start.advanced(segment.twist(), segment.t());
      from = 0;
    }
    return poses;
  }

  /**
   * Metres of the path from here to where a segment begins; below 0 behind the reference.
   *
   * @param index of the segment, or the number of segments: where the last one ends
   */
  double metresTo(int index) {
    int here = completedCount;
    double metres = 0;
    for (int i = Math.min(index, here); i < Math.max(index, here); i++) {
      metres += segments.get(i).length();
    }
    double done = here < segments.size() ? segments.get(here).speed() * timeInSegment : 0;
    return (index < here ? -metres : metres) - done;
  }

  /** Where a segment that is not left behind begins, map frame; or where the last one ends. */
  public Pose startOf(int index) {
    Pose start = segmentStart;
    for (Segment segment : segments.subList(completedCount, index)) {
      start = start.advanced(segment.twist(), segment.t());
    }
    return start;
  }

  /** How many segments there are. */
  public int size() {
    return segments.size();
  }

  /** How many segments may be driven, from the first. */
  public int releasedCount() {
    return releasedCount;
  }

  /** How many segments the reference has left behind. */
  public int completedCount() {
    return completedCount;
  }

  /**
   * A segment.
   *
   * @param index from 0
   */
  public Segment segment(int index) {
    return segments.get(index);
  }

  /** How much of the planned time of the segment that it is on lies behind the reference. */
  public double secondsInSegment() {
    return timeInSegment;
  }

  /** As a share of the planned speed, 0 to 1. */
  public double pace() {
    return pace;
  }

  /** Whether the reference is stopped. */
  public boolean isStanding() {
    return pace == 0;
  }

  /** The reference, map frame. */
  public Pose pose() {
    return completedCount == segments.size()
        ? segmentStart
        : segmentStart.advanced(segments.get(completedCount).twist(), timeInSegment);
  }

  /** The reference's velocity, in its own frame. */
  public Twist twist() {
    return completedCount == segments.size()
        ? Twist.ZERO
        : segments.get(completedCount).twist().times(pace);
  }

  /** The velocity that is planned here, in the reference's own frame. */
  Twist plannedTwist() {
    return completedCount == segments.size() ? Twist.ZERO : segments.get(completedCount).twist();
  }

  /**
   * Moves the reference on.
   *
   * @param wantedPace 0 to 1; reached as soon as the limits allow
   */
  void advance(double seconds, double wantedPace) {
    double step = paceRate * seconds;
    double reachable = Math.max(pace - step, Math.min(pace + step, wantedPace));
    pace = Math.min(reachable, allowedPace(step));
    double time = pace * seconds;
    while (completedCount < releasedCount
        && timeInSegment + time >= segments.get(completedCount).t() - COMPLETED_SECONDS) {
      Segment done = segments.get(completedCount);
      time = Math.max(0, timeInSegment + time - done.t());
      leaveSegment();
    }
    if (completedCount == releasedCount) {
      pace = 0;
    } else {
      timeInSegment += time;
    }
  }

  /**
   * @param step by how much the pace may change in the tick
   */
  private double allowedPace(double step) {
    double allowed = 1;
    double timeAhead = -timeInSegment;
    for (int i = completedCount;
        i < releasedCount && 2 * paceRate * timeAhead < 1 + 2 * step;
        i++) {
      timeAhead += segments.get(i).t();
      double there =
          i + 1 == releasedCount ? 0 : junctionPace(segments.get(i), segments.get(i + 1));
      allowed =
          Math.min(
              allowed, Math.sqrt(there * there + 2 * paceRate * timeAhead + step * step) - step);
    }
    double untilStand = timeToCover(stopDistance);
    if (untilStand < Double.POSITIVE_INFINITY) {
      allowed = Math.min(allowed, Math.sqrt(2 * paceRate * untilStand + step * step) - step);
    }
    return completedCount == releasedCount ? 0 : allowed;
  }

  /** How long the reference takes over so many metres as planned; infinite beyond the released. */
  private double timeToCover(double metres) {
    double seconds = -timeInSegment;
    double left = metres;
    for (int i = completedCount; i < releasedCount && left < Double.POSITIVE_INFINITY; i++) {
      Segment segment = segments.get(i);
      left += i == completedCount ? segment.speed() * timeInSegment : 0;
      if (segment.speed() != 0 && left <= segment.length()) {
        return seconds + left / segment.speed();
      }
      left -= segment.length();
      seconds += segment.t();
    }
    return Double.POSITIVE_INFINITY;
  }

  private double maxPaceRate(Segment segment) {
    return Math.min(
        MAX_PACE_RATE,
        Math.min(
            limits.acceleration() / segment.speed(),
            limits.turnAcceleration() / Math.abs(segment.w())));
  }

  private double junctionPace(Segment before, Segment after) {
    return Math.min(
        1,
        Math.min(
            limits.speedJump() / Math.hypot(after.v() - before.v(), after.u() - before.u()),
            limits.turnRateJump() / Math.abs(after.w() - before.w())));
  }
}
