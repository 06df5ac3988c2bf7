package org.toqa.avoidance;

import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * The path right ahead of a robot, as a line that its middle will follow.
 *
 * @param line poses on it, map frame, the first where the robot is; between two of them it goes
 *     straight
 */
public record Corridor(List<Pose> line) {

  /**
   * Where a thing is beside the line.
   *
   * @param along metres on the line to the point nearest to it
   * @param distance metres from there to the thing
   */
  public record Place(double along, double distance) {}

  /** Metres behind its beginning, and beyond its end, where it counts as going on straight. */
  private static final double STRAIGHT_ON = 1;

  /**
   * Where a thing is beside the line, also behind the robot and beyond the line's end.
   *
   * @param along metres on the line to the point nearest to it; below 0 behind the robot
   * @param left metres from there to the thing, to the left of the line
   */
  public record Beside(double along, double left) {}

  /**
   * @throws IllegalArgumentException if the line is empty
   */
  public Corridor {
    line = List.copyOf(line);
    if (line.isEmpty()) {
      throw new IllegalArgumentException("A corridor begins where the robot is.");
    }
  }

  /** Metres along the line. */
  public double length() {
    double length = 0;
    for (int i = 1; i < line.size(); i++) {
      length += line.get(i - 1).distanceTo(line.get(i));
    }
    return length;
  }

  /** Where a point is, map frame; empty for what lies behind the robot. */
  public Optional<Place> place(Vec2 point) {
    Pose here = line.getFirst();
    Place nearest = new Place(0, point.distanceTo(here.position()));
    boolean isBehind = point.minus(here.position()).rotated(-here.theta()).x() < 0;
    double along = 0;
    for (int i = 1; i < line.size(); i++) {
      Pose from = line.get(i - 1);
      Pose to = line.get(i);
      double length = from.distanceTo(to);
      double distance = point.distanceToLine(from.position(), to.position());
      if (distance < nearest.distance) {
        double fromStart = point.distanceTo(from.position());
        double part = Math.sqrt(Math.max(0, fromStart * fromStart - distance * distance));
        nearest = new Place(along + Math.min(part, length), distance);
      }
      along += length;
    }
    return isBehind && nearest.along == 0 ? Optional.empty() : Optional.of(nearest);
  }

  /**
   * The pose on the line, or straight beyond its ends.
   *
   * @param along metres
   */
  public Pose poseAt(double along) {
    double left = along;
    for (int i = 1; i < line.size() && along > 0; i++) {
      Pose from = line.get(i - 1);
      Pose to = line.get(i);
      double length = from.distanceTo(to);
      if (left <= length && length > 0) {
        Vec2 way = to.position().minus(from.position()).times(left / length);
        double turned = Angles.difference(from.theta(), to.theta()) * left / length;
        return new Pose(from.x() + way.x(), from.y() + way.y(), from.theta() + turned);
      }
      left -= length;
    }
    Pose end = along > 0 ? line.getLast() : line.getFirst();
    return end.compose(new Pose(left, 0, 0));
  }

  /**
   * How much the line turns there, radians a metre, counter-clockwise.
   *
   * @param along metres
   */
  public double curvatureAt(double along) {
    double left = along;
    for (int i = 1; i < line.size(); i++) {
      double length = line.get(i - 1).distanceTo(line.get(i));
      if (left < length) {
        return Angles.difference(line.get(i - 1).theta(), line.get(i).theta()) / length;
      }
      left -= length;
    }
    return 0;
  }

  /** Where a point is, map frame. */
  public Beside beside(Vec2 point) {
    Vec2 atStart = point.minus(line.getFirst().position()).rotated(-line.getFirst().theta());
    Beside nearest = new Beside(atStart.x(), atStart.y());
    double distance =
        atStart.x() <= 0 && atStart.x() > -STRAIGHT_ON ? Math.abs(atStart.y()) : atStart.norm();
    double along = 0;
    for (int i = 1; i < line.size(); i++) {
      Vec2 from = line.get(i - 1).position();
      Vec2 way = line.get(i).position().minus(from);
      double length = way.norm();
      if (length == 0) {
        continue;
      }
      Vec2 place = point.minus(from).rotated(-way.angle());
      double on = Math.clamp(place.x(), 0, length);
      double apart = Math.hypot(place.x() - on, place.y());
      if (apart < distance) {
        distance = apart;
        nearest = new Beside(along + on, Math.copySign(apart, place.y()));
      }
      along += length;
    }
    Vec2 atEnd = point.minus(line.getLast().position()).rotated(-line.getLast().theta());
    boolean isBeyond = atEnd.x() >= 0 && atEnd.x() < STRAIGHT_ON;
    return isBeyond && Math.abs(atEnd.y()) <= distance
        ? new Beside(along + atEnd.x(), atEnd.y())
        : nearest;
  }
}
