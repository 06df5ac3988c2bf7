package org.toqa.agent;

import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** Sees how a simulated body really moves, whatever its daemon believes. */
final class MotionRecorder implements Surroundings {

  private static final double TICK_SECONDS = Chassis.TICK.toNanos() / 1e9;

  private @Nullable Pose last;
  private double moved;
  private double fastest;
  private double fastestTurn;

  @Override
  public void setTruePose(Pose truth) {
    if (last != null) {
      double metres = last.distanceTo(truth);
      double radians = Math.abs(Angles.difference(last.theta(), truth.theta()));
      moved += metres + radians;
      fastest = Math.max(fastest, metres / TICK_SECONDS);
      fastestTurn = Math.max(fastestTurn, radians / TICK_SECONDS);
    }
    last = truth;
  }

  @Override
  public double distance(Pose ray, double farthest) {
    return farthest;
  }

  @Override
  public boolean isMarked(Vec2 point) {
    return false;
  }

  /** Metres and radians since the last call; 0 for a body that did not move. */
  double takeMoved() {
    double since = moved;
    moved = 0;
    return since;
  }

  /** Metres a second. */
  double fastest() {
    return fastest;
  }

  /** Radians a second. */
  double fastestTurn() {
    return fastestTurn;
  }
}
