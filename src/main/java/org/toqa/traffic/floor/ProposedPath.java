package org.toqa.traffic.floor;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * How a robot's path is to go on behind what was released of it when the floor was pictured.
 *
 * @param robot its name
 * @param path that part of the path; without sections but inherited ones: it is to stop there
 * @param number of the path, by which others in the plan wait for it
 * @param releasedAtOnce so many of the sections lead to where it was planned from, and are to be
 *     driven at once
 * @param waitsSince since when it then waits short of its goal; null: it does not
 */
record ProposedPath(
    String robot, ReservedPath path, int number, int releasedAtOnce, @Nullable Instant waitsSince) {

  /** What planning made of a robot's path; to be asked if that is another one. */
  static ProposedPath of(TrafficRobot pictured, TrafficRobot planned) {
    ReservedPath path = planned.drive.path();
    if (path == null) {
      throw new IllegalArgumentException(planned.name + " has no path.");
    }
    int released = pictured.drive.released();
    return new ProposedPath(
        planned.name,
        path.from(released),
        planned.drive.pathNumber(),
        planned.drive.released() - released,
        planned.waiting.since());
  }

  ProposedPath withPath(ReservedPath other) {
    return new ProposedPath(robot, other, number, releasedAtOnce, waitsSince);
  }

  boolean isStop() {
    return path.sectionCount() == path.inherited();
  }

  /** Whether it has no order with others' paths, since it meets none. */
  boolean isIndependent() {
    return !isStop() && !path.isShared() && releasedAtOnce == 0;
  }
}
