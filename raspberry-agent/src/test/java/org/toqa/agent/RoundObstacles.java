package org.toqa.agent;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** A floor with round things; it watches how near the robot really comes to any of them. */
final class RoundObstacles implements Surroundings {
  private static final double STEP = 0.001;

  /** Metres a second; who is slower stands. */
  private static final double STANDING = 0.01;

  private static final double ROBOT = 0.255 / 2;

  private final List<Obstacle> obstacles = new ArrayList<>();
  private boolean isMiddleBlind;
  private Vec2 walking = Vec2.ZERO;
  private Vec2 walkingFrom = Vec2.ZERO;
  private Pose truth = Rig.START;
  private Pose last = Rig.START;
  private boolean wasDrivenInto;
  private double nearest = Double.POSITIVE_INFINITY;
  private LongSupplier clock = () -> 0;
  private long lastNanos;

  private record Obstacle(Vec2 middle, double radius, Vec2 velocity) {
    double gap(Vec2 point) {
      return middle.distanceTo(point) - radius;
    }

    Obstacle after(double seconds) {
      return new Obstacle(middle.plus(velocity.times(seconds)), radius, velocity);
    }
  }

  void put(Vec2 middle, double radius) {
    putMoving(middle, radius, Vec2.ZERO);
  }

  /**
   * @param velocity metres a second of the robot's time
   */
  void putMoving(Vec2 middle, double radius, Vec2 velocity) {
    obstacles.add(new Obstacle(middle, radius, velocity));
  }

  /**
   * It moves as the robot does, so that it is there when the robot comes.
   *
   * @param middle where it is while the robot is at its start
   * @param pace metres for each metre that the robot is east of that
   */
  void putWalking(Vec2 middle, double radius, Vec2 pace) {
    walking = pace;
    walkingFrom = middle;
    put(middle, radius);
  }

  /**
   * Things move by that clock from now on; before, they stand.
   *
   * @param nanos of the robot's time
   */
  void follow(LongSupplier nanos) {
    clock = nanos;
    lastNanos = nanos.getAsLong();
  }

  void clear() {
    obstacles.clear();
  }

  void blindMiddle() {
    isMiddleBlind = true;
  }

  /** Whether the robot, by its own motion, ever came nearer to a thing that it touched. */
  boolean wasDrivenInto() {
    return wasDrivenInto;
  }

  /** Where the robot really is. */
  Pose truth() {
    return truth;
  }

  /** Metres between the robot's rim and a thing at their nearest. */
  double nearest() {
    return nearest;
  }

  @Override
  public void setTruePose(Pose now) {
    truth = now;
    double seconds = (clock.getAsLong() - lastNanos) / 1e9;
    lastNanos = clock.getAsLong();
    obstacles.replaceAll(thing -> thing.after(seconds));
    if (!walking.equals(Vec2.ZERO)) {
      Vec2 walked = walking.times(now.x() - Rig.START.x());
      obstacles.replaceAll(
          thing -> new Obstacle(walkingFrom.plus(walked), thing.radius(), Vec2.ZERO));
    }
    double least = STANDING * seconds;
    wasDrivenInto |=
        obstacles.stream()
            .filter(thing -> thing.gap(now.position()) < ROBOT)
            .anyMatch(thing -> thing.gap(last.position()) - thing.gap(now.position()) > least);
    last = now;
    obstacles.forEach(thing -> nearest = Math.min(nearest, thing.gap(now.position()) - ROBOT));
  }

  @Override
  public double distance(Pose ray, double farthest) {
    if (isMiddleBlind && Math.abs(Angles.difference(ray.theta(), truth.theta())) < 0.01) {
      return farthest;
    }
    for (double metres = 0; metres < farthest; metres += STEP) {
      Vec2 point = ray.compose(new Pose(metres, 0, 0)).position();
      if (obstacles.stream().anyMatch(thing -> thing.gap(point) < 0)) {
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
