package org.toqa.localisation;

import java.util.Optional;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/** What stands on a map for good, as a range sensor meets it. */
@FunctionalInterface
public interface Walls {

  /**
   * Where a ray meets a face of a wall.
   *
   * @param distance metres along the ray
   * @param normal of the face, of length 1, map frame, towards where the ray comes from
   */
  record Hit(double distance, Vec2 normal) {}

  /**
   * The first face that a ray meets; empty where none is so near, or the ray begins in a wall.
   *
   * @param beam where the ray begins and leads, map frame
   * @param farthest metres
   */
  Optional<Hit> hit(Pose beam, double farthest);
}
