package org.toqa.forecast;

import org.toqa.allocation.PathLengths;
import org.toqa.geometry.Vec2;

/** The paths of a floor, by its map. */
public interface Travel extends PathLengths {

  /**
   * What a robot drives from one place to another that nobody hinders.
   *
   * @param from metres, map frame
   * @param to metres, map frame
   * @param diameter of the robot, metres
   * @return {@link Drive#IMPOSSIBLE} where no path is wide enough
   */
  Drive drive(Vec2 from, Vec2 to, double diameter);
}
