package org.toqa.agent;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Segment;

/**
 * The way that a drive leads along, as a moving reference: a pose that runs over the released
 * segments at a pace between 0 (stands) and 1 (as planned).
 *
 * <p>Slowing down scales time and not the path, so that a robot that brakes stays on the curve that
 * was planned and checked. The pace rises and falls with the acceleration limits; before the end of
 * what is released, and before a corner where the velocity jumps, it falls in time: with braking
 * rate a and planned time T left to a place where the pace may be p, the pace P of the next tick is
 * as high as P^2 = p^2 + 2 a (T - P tick) allows (the look-ahead of machine-tool controllers, with
 * a junction limit as in grbl).
 */
public final class Way {

  /** Paces a second at most, also for segments that only wait. */
  private static final double STEEPEST_PACE = 10;

  /** Seconds; a segment with less than this left is completed. */
  private static final double INSTANT = 1e-6;

  /** Metres of an arc that are taken for straight: at a radius of 0.15 m it rises 0.3 mm. */
  private static final double PIECE = 0.02;

  private final List<Segment> segments = new ArrayList<>();
  private PaceLimits limits;
  private int released;
  private double paceRate = STEEPEST_PACE;

  private int completed;
  private Pose segmentStart;
  private double timeInSegment;
  private double pace;

  /** Metres that it may still go, whatever is released. */
  private double room = Double.POSITIVE_INFINITY;

  public Way(Pose start, List<Segment> segments, int released, PaceLimits limits) {
    this.limits = limits;
    this.segmentStart = start;
    replace(0, segments, released);
  }

  /** Replaces the segments with index {@code from} and above, none of which was released. */
  void replace(int from, List<Segment> tail, int nowReleased) {
    segments.subList(from, segments.size()).clear();
    segments.addAll(tail);
    released = nowReleased;
    rate();
  }

  /** From now on its velocity changes no more abruptly than this. */
  void limit(PaceLimits newLimits) {
    if (!limits.equals(newLimits)) {
      limits = newLimits;
      rate();
    }
  }

  private void rate() {
    paceRate = segments.stream().mapToDouble(this::paceRateOf).min().orElse(STEEPEST_PACE);
  }

  void release(int count) {
    released = count;
  }

  /**
   * From now on it comes to a stand within so many metres; turns on the spot are none. Where that
   * is too short to slow down, it stands at once.
   */
  void standWithin(double metres) {
    room = metres;
  }

  /**
   * The released way from here on, as poses of which each follows from the one before on a straight
   * line, or nearly so.
   *
   * @param metres how far
   */
  List<Pose> ahead(double metres) {
    List<Pose> poses = new ArrayList<>();
    poses.add(pose());
    Pose start = segmentStart;
    double from = timeInSegment;
    double left = metres;
    for (int i = completed; i < released && left > 0; i++) {
      Segment segment = segments.get(i);
      if (segment.v() != 0) {
        double length = Math.min(left, Math.abs(segment.v()) * (segment.t() - from));
        int pieces = segment.w() == 0 ? 1 : (int) Math.ceil(length / PIECE);
        for (int piece = 1; piece <= pieces; piece++) {
          double metresIn = length * piece / pieces;
          poses.add(start.advanced(segment.twist(), from + metresIn / Math.abs(segment.v())));
        }
        left -= length;
      }
      start = start.advanced(segment.twist(), segment.t());
      from = 0;
    }
    return poses;
  }

  public int size() {
    return segments.size();
  }

  int released() {
    return released;
  }

  /** How many segments the reference has left behind. */
  public int completed() {
    return completed;
  }

  /** The reference stands. */
  public boolean stands() {
    return pace == 0;
  }

  /** The reference, map frame. */
  public Pose pose() {
    return completed == segments.size()
        ? segmentStart
        : segmentStart.advanced(segments.get(completed).twist(), timeInSegment);
  }

  /** The reference's velocity, in its own frame. */
  public Twist twist() {
    return completed == segments.size() ? Twist.ZERO : segments.get(completed).twist().times(pace);
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
    while (completed < released && timeInSegment + time >= segments.get(completed).t() - INSTANT) {
      Segment done = segments.get(completed);
      time = Math.max(0, timeInSegment + time - done.t());
      segmentStart = segmentStart.advanced(done.twist(), done.t());
      timeInSegment = 0;
      completed++;
    }
    if (completed == released) {
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
    for (int i = completed; i < released && 2 * paceRate * timeAhead < 1 + 2 * step; i++) {
      timeAhead += segments.get(i).t();
      double there = i + 1 == released ? 0 : paceOverJunction(segments.get(i), segments.get(i + 1));
      allowed =
          Math.min(
              allowed, Math.sqrt(there * there + 2 * paceRate * timeAhead + step * step) - step);
    }
    double untilStand = secondsOver(room);
    if (untilStand < Double.POSITIVE_INFINITY) {
      allowed = Math.min(allowed, Math.sqrt(2 * paceRate * untilStand + step * step) - step);
    }
    return completed == released ? 0 : allowed;
  }

  /** How long the reference takes over so many metres as planned; infinite beyond the released. */
  private double secondsOver(double metres) {
    double seconds = -timeInSegment;
    double left = metres;
    for (int i = completed; i < released && left < Double.POSITIVE_INFINITY; i++) {
      Segment segment = segments.get(i);
      left += i == completed ? Math.abs(segment.v()) * timeInSegment : 0;
      if (segment.v() != 0 && left <= segment.length()) {
        return seconds + left / Math.abs(segment.v());
      }
      left -= segment.length();
      seconds += segment.t();
    }
    return Double.POSITIVE_INFINITY;
  }

  private double paceRateOf(Segment segment) {
    return Math.min(
        STEEPEST_PACE,
        Math.min(
            limits.acceleration() / Math.abs(segment.v()),
            limits.turnAcceleration() / Math.abs(segment.w())));
  }

  private double paceOverJunction(Segment before, Segment after) {
    return Math.min(
        1,
        Math.min(
            limits.speedJump() / Math.abs(after.v() - before.v()),
            limits.turnRateJump() / Math.abs(after.w() - before.w())));
  }
}
