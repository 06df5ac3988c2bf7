package org.toqa.fleet;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Trajectory;

/**
 * Where a robot is, by what was stored of it.
 *
 * @param diameter of the disc that it fills, metres
 * @param sinceDriven it may be anywhere on that; without segments: it stands where that begins
 * @param room that it was lent beside that; null: none
 */
public record LastPlace(double diameter, Trajectory sinceDriven, @Nullable PassingRoom room) {

  /** It drives that, and has no room beside it. */
  public LastPlace(double diameter, Trajectory sinceDriven) {
    this(diameter, sinceDriven, null);
  }

  public static LastPlace standing(Pose pose, double diameter) {
    return new LastPlace(diameter, new Trajectory(pose, List.of()));
  }

  /** Where it stood last, map frame. */
  public Pose pose() {
    return sinceDriven.start();
  }
}
