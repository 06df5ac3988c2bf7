package org.toqa.agent;

import java.util.ArrayList;
import java.util.List;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** A floor with round things; it watches how near the robot really comes to any of them. */
final class RoundThings implements Surroundings {
  private static final double STEP = 0.001;
  private static final double TICK = 0.02;
  private static final double ROBOT = 0.255 / 2;

  private final List<Thing> things = new ArrayList<>();
  private boolean isMiddleBlind;
  private Pose truth = Rig.START;
  private double nearest = Double.POSITIVE_INFINITY;

  private record Thing(Vec2 middle, double radius, Vec2 velocity) {
    double gap(Vec2 point) {
      return middle.distanceTo(point) - radius;
    }

    Thing later() {
      return new Thing(middle.plus(velocity.times(TICK)), radius, velocity);
    }
  }

  void put(Vec2 middle, double radius) {
    putMoving(middle, radius, Vec2.ZERO);
  }

  /**
   * @param velocity metres a second of the robot's time
   */
  void putMoving(Vec2 middle, double radius, Vec2 velocity) {
    things.add(new Thing(middle, radius, velocity));
  }

  void clear() {
    things.clear();
  }

  void blindMiddle() {
    isMiddleBlind = true;
  }

  /** Metres between the robot's rim and a thing at their nearest. */
  double nearest() {
    return nearest;
  }

  @Override
  public void isAt(Pose now) {
    truth = now;
    things.replaceAll(Thing::later);
    things.forEach(thing -> nearest = Math.min(nearest, thing.gap(now.position()) - ROBOT));
  }

  @Override
  public double distance(Pose ray, double farthest) {
    if (isMiddleBlind && Math.abs(Angles.difference(ray.theta(), truth.theta())) < 0.01) {
      return farthest;
    }
    for (double metres = 0; metres < farthest; metres += STEP) {
      Vec2 point = ray.compose(new Pose(metres, 0, 0)).position();
      if (things.stream().anyMatch(thing -> thing.gap(point) < 0)) {
        return metres;
      }
    }
    return farthest;
  }

  @Override
  public boolean isMarked(Vec2 point) {
    return false;
  }
}
