package org.toqa.traffic.lifelong;

import java.util.List;
import org.toqa.traffic.GridPose;

/**
 * The next steps of one robot.
 *
 * @param poses from the present one on, a step apart
 */
public record PlannedPath(List<GridPose> poses, PlanStatus status) {
  public PlannedPath {
    poses = List.copyOf(poses);
  }

  /** The pose after so many steps; the last one from there on. */
  public GridPose at(int step) {
    return poses.get(Math.min(step, poses.size() - 1));
  }
}
