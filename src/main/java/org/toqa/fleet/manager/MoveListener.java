package org.toqa.fleet.manager;

import org.toqa.geometry.Pose;
import org.toqa.grid.FloorMap;

/** Is told of robots that were carried to another floor. */
@FunctionalInterface
public interface MoveListener {
  /**
   * @param floor where it is now
   * @param pose where it stands there, map frame
   */
  void moved(String robot, FloorMap floor, Pose pose);
}
