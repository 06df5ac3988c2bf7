package org.toqa.traffic.floor;

import org.jspecify.annotations.Nullable;

/** What becomes of a step that a person asks for who drives a robot by hand. */
public sealed interface ManualStep {

  /**
   * It is the robot's own, and may be driven.
   *
   * @param command what the robot is to be told
   */
  record Granted(DriveCommand command) implements ManualStep {}

  /** The robot has enough to drive for now. */
  record NotNeeded() implements ManualStep {}

  /**
   * Nothing has changed.
   *
   * @param robot whose place it is, where another robot is why; else null
   */
  record Refused(Reason reason, @Nullable String robot) implements ManualStep {}

  /** Why a step is refused. */
  enum Reason {
    /** A wall, a keep-out area or the end of the map. */
    WALL,
    /** Something that robots saw, or a load. */
    OBSTACLE,
    /** Another robot is there, or may drive there. */
    ROBOT,
    /** It would be against the direction of an area. */
    DIRECTION
  }
}
