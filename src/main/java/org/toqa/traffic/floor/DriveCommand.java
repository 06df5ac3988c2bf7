package org.toqa.traffic.floor;

import java.util.List;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** What a robot is to be told; counts and indices are of segments. */
public sealed interface DriveCommand {

  String robot();

  /**
   * Begin a path; the robot is stopped.
   *
   * @param endsAtGoal whether the path ends at its goal
   */
  record Begin(String robot, Trajectory trajectory, int released, boolean endsAtGoal)
      implements DriveCommand {}

  /** Drive another path from segment {@code from} on; all before it has been released. */
  record Extend(String robot, int from, List<Segment> segments, int released, boolean endsAtGoal)
      implements DriveCommand {}

  /** So many segments may be driven now. */
  record Release(String robot, int released) implements DriveCommand {}

  /** There is room beside its path, to drive round what it sees there. */
  record Room(String robot, PassingRoom room) implements DriveCommand {}
}
