package org.toqa.avoidance;

import java.util.List;
import java.util.Optional;
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
}
