package org.toqa.fleet.floor;

import java.util.List;
import java.util.Optional;
import org.toqa.formation.LoadHolds;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.traffic.floor.FormationFootprint;

/**
 * Who is where round a load that several robots pick up.
 *
 * @param shape the leader first, as the mission names its robots
 * @param load where it is picked up, and with which heading, map frame
 * @param size of the load
 * @param group the same, as the traffic knows it
 */
record Formation(Shape shape, Pose load, LoadSize size, FormationFootprint group) {
  /** Metres that a follower may be off its place. */
  double tolerance() {
    return shape.law().tolerance();
  }

  private static final double EIGHTH = Math.PI / 4;

  /**
   * Of a load's length from the way that the group faces, radians: a square one lies along the map.
   */
  static double turnOf(Pose load, LoadSize size) {
    boolean isAskew = Math.round(load.theta() / EIGHTH) % 2 != 0;
    return isAskew && size.length() == size.width() ? EIGHTH : 0;
  }

  /** Where the robots hold the load, from its middle, in the frame of the way that they face. */
  Optional<List<Vec2>> holds(List<Double> shares) {
    return LoadHolds.of(shape, size.length(), size.width(), turnOf(load, size), shares);
  }

  /**
   * Where a robot holds the load, in its own frame as it stands at its place.
   *
   * @param index as in {@link #pose}
   */
  Optional<Vec2> holdFrom(int index, List<Double> shares) {
    return holds(shares).map(points -> points.get(index).minus(place(index)));
  }

  /**
   * Where each robot is to pick the load up; all face alike.
   *
   * @param index of the robot among the mission's, 0 for the leader
   */
  Pose pose(int index) {
    Vec2 place = place(index);
    return load.compose(new Pose(place.x(), place.y(), 0));
  }

  /**
   * Where a robot is, from the load's middle, in the frame of the way that they face.
   *
   * @param index as in {@link #pose}
   */
  Vec2 place(int index) {
    return index == 0 ? shape.leader() : shape.followers().get(index - 1);
  }

  /** Where a follower keeps its place, in the leader's frame. */
  Vec2 offset(int index) {
    return shape.offsets().get(index - 1);
  }
}
