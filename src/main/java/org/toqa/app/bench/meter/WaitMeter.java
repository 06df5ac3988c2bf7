package org.toqa.app.bench.meter;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** How long robots that have a goal stand short of it, and what is said why. */
public final class WaitMeter {
  /** Metres; a robot that has moved by less stands. */
  private static final double MOVED = 0.05;

  private final Vec2[] places;
  private final long[] since;
  private final long[] unnamedSince;
  private final @Nullable String[] reasons;
  private final @Nullable String[] lastReasons;

  private long longest;
  private long longestUnnamed;
  private int longestRobot;
  private @Nullable String longestReason;

  /**
   * @param places where the robots begin, map frame
   */
  public WaitMeter(Vec2[] places) {
    this.places = places.clone();
    since = new long[places.length];
    unnamedSince = new long[places.length];
    reasons = new String[places.length];
    lastReasons = new String[places.length];
  }

  /** The robot has a new goal. */
  public void setGoal(int robot, long nanos) {
    begin(robot, nanos);
    reasons[robot] = null;
  }

  private void begin(int robot, long nanos) {
    since[robot] = nanos;
    unnamedSince[robot] = nanos;
    lastReasons[robot] = null;
  }

  /**
   * What the floor says why the robot does not get on.
   *
   * @param reason null: nothing
   */
  public void setReason(int robot, @Nullable String reason) {
    reasons[robot] = reason;
  }

  /** Where the robot is, map frame. */
  public void observe(int robot, Vec2 at, long nanos) {
    if (places[robot].distanceTo(at) > MOVED) {
      places[robot] = at;
      begin(robot, nanos);
    }
    if (reasons[robot] != null) {
      unnamedSince[robot] = nanos;
      lastReasons[robot] = reasons[robot];
    }
    if (nanos - since[robot] > longest) {
      longest = nanos - since[robot];
      longestRobot = robot;
      longestReason = lastReasons[robot];
    }
    longestUnnamed = Math.max(longestUnnamed, nanos - unnamedSince[robot]);
  }

  /** Seconds. */
  public double longest() {
    return longest / 1e9;
  }

  /** Of those in which nothing was said why; seconds. */
  public double longestUnnamed() {
    return longestUnnamed / 1e9;
  }

  /** The index of the robot that waited longest. */
  public int longestRobot() {
    return longestRobot;
  }

  /** What was said last of that wait; null: nothing. */
  public @Nullable String longestReason() {
    return longestReason;
  }
}
