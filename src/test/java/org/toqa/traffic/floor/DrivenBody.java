package org.toqa.traffic.floor;

import static org.toqa.traffic.floor.DrivenFloor.require;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** A robot of a {@link DrivenFloor} as it really is; it drives what it is told, and looks on. */
final class DrivenBody {
  /** So near to its goal, metres, a robot has to come. */
  private static final double ARRIVED = 0.03;

  Pose pose;
  double diameter;
  @Nullable Trajectory trajectory;
  int released;
  int completed;
  boolean last;
  double inSegment;
  boolean isStuck;
  @Nullable Vec2 goal;

  /** Metres a second; it cannot drive faster. */
  double maxSpeed = Double.POSITIVE_INFINITY;

  /** How far it really is from where it takes itself to be, metres. */
  Vec2 error = Vec2.ZERO;

  /** Room beside its path; null: none. */
  @Nullable PassingRoom room;

  /** Whether it has taken room, and its traffic does not know yet that it is over. */
  boolean isRoomTaken;

  /** Metres that it is to the left of its path. */
  double aside;

  /** Who drives with it. */
  @Nullable FormationFootprint group;

  DrivenBody(Pose pose, double diameter) {
    this.pose = pose;
    this.diameter = diameter;
  }

  /** Where it really is. */
  List<PlacedDisc> discs() {
    return group == null
        ? List.of(new PlacedDisc(place().position().plus(error), diameter / 2))
        : group.discs(pose);
  }

  /** Where it takes itself to be, on its path or in its room beside that. */
  Pose place() {
    return aside == 0 ? pose : pose.compose(new Pose(0, aside, 0));
  }

  /** Whether it is so near to another one that the two have to be looked at. */
  boolean mayTouch(DrivenBody other) {
    return place().position().distanceTo(other.place().position()) < reach() + other.reach();
  }

  /** No part of it is farther from its pose, metres. */
  private double reach() {
    return discs().stream()
        .mapToDouble(disc -> disc.centre().distanceTo(place().position()) + disc.radius())
        .max()
        .orElseThrow();
  }

  /** Lets its error become another one, by a little. */
  void drift(double most, SplittableRandom chance) {
    Vec2 next =
        error.plus(
            new Vec2(chance.nextDouble(-0.2, 0.2), chance.nextDouble(-0.2, 0.2)).times(most));
    error = next.norm() > most ? next.times(most / next.norm()) : next;
  }

  /** Where what it carries is. */
  Vec2 carries() {
    return group == null ? pose.position() : group.shape().loadAt(pose).position();
  }

  double arrived(OccupancyGrid grid) {
    return group == null ? ARRIVED : FormationLattice.goalTolerance(grid) + ARRIVED;
  }

  /** Takes a command, if that is one that it may be given now. */
  void obey(DriveCommand decision) {
    change(decision);
    if (trajectory != null) {
      require(
          trajectory.segments().stream().allMatch(s -> s.speed() < maxSpeed + 1e-9),
          decision.robot() + " was told to drive faster than it can");
    }
  }

  private void change(DriveCommand decision) {
    switch (decision) {
      case DriveCommand.Begin begin -> {
        require(trajectory == null, decision.robot() + " was told to begin while it drives");
        require(
            begin.trajectory().start().distanceTo(pose) < (group == null ? 1e-6 : 0.01),
            decision.robot() + " was told to begin elsewhere");
        trajectory = begin.trajectory();
        released = begin.released();
        completed = 0;
        inSegment = 0;
        last = begin.endsAtGoal();
      }
      case DriveCommand.Extend extend -> {
        Trajectory old =
            Objects.requireNonNull(
                trajectory, () -> decision.robot() + " was told to go on while it is stopped");
        require(extend.from() >= released, decision.robot() + ": a released section was changed");
        List<Segment> segments = new ArrayList<>(old.segments().subList(0, extend.from()));
        segments.addAll(extend.segments());
        trajectory = new Trajectory(old.start(), segments);
        released = extend.released();
        last = extend.endsAtGoal();
      }
      case DriveCommand.Release release -> {
        require(release.released() > released, decision.robot() + ": released less");
        released = release.released();
      }
      case DriveCommand.Room lent -> {
        require(trajectory != null, decision.robot() + " was lent room while it is stopped");
        require(
            lent.room().to() <= released, decision.robot() + ": room where nothing is released");
        room = lent.room();
        isRoomTaken = true;
      }
    }
  }

  /**
   * Drives on, as late as chance will have it.
   *
   * @param seconds that have passed
   */
  void move(double seconds, SplittableRandom chance) {
    Trajectory driven = trajectory;
    if (driven == null || isStuck) {
      return;
    }
    double left = seconds * (chance.nextInt(4) == 0 ? 0 : chance.nextDouble(0.3, 1));
    while (left > 0 && completed < released) {
      double t = driven.segments().get(completed).t();
      double used = Math.min(left, t - inSegment);
      inSegment += used;
      left -= used;
      if (inSegment >= t - 1e-12) {
        completed++;
        inSegment = 0;
      }
    }
    Pose at = driven.poseAfter(completed);
    pose =
        completed < driven.segments().size()
            ? at.advanced(driven.segments().get(completed).twist(), inSegment)
            : at;
    moveAside(chance);
    if (last && completed == driven.segments().size()) {
      trajectory = null;
    }
  }

  /** Anywhere in its room, until it gives that back behind it. */
  private void moveAside(SplittableRandom chance) {
    PassingRoom lent = room;
    if (lent == null || completed >= lent.to()) {
      room = null;
      aside = 0;
    } else if (completed >= lent.from()) {
      double to = chance.nextBoolean() ? lent.left() : -lent.right();
      aside = chance.nextInt(3) == 0 ? to : to * chance.nextDouble();
    }
  }
}
