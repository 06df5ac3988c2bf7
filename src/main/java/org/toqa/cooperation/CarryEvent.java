package org.toqa.cooperation;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** What is heard and seen. */
public sealed interface CarryEvent {

  /**
   * Cameras found a box, or found again one whose place was not known.
   *
   * @param by whose cameras
   * @param place metres, map frame
   * @param isAtTarget whether it lies where it shall be
   */
  record BoxSeen(String by, int box, Vec2 place, boolean isAtTarget) implements CarryEvent {}

  /** The map of what is seen has grown. */
  record MapGrown() implements CarryEvent {}

  /** For a robot with cameras nothing of the store is unseen. */
  record StoreSeen(String by) implements CarryEvent {}

  /**
   * Where a robot is.
   *
   * @param position metres, map frame
   * @param battery 0 to 1
   * @param workSeconds since it last charged
   * @param station the charging station that it stands at
   */
  record RobotReported(
      String robot, Vec2 position, double battery, double workSeconds, @Nullable Integer station)
      implements CarryEvent {}

  /** A worker is at its box and has weighed it by the load sensor of its arm. */
  record BoxWeighed(String worker, double kilograms) implements CarryEvent {}

  /** A worker that was called is at the other side of its box. */
  record SecondArrived(String worker) implements CarryEvent {}

  /** A box lies at its target. */
  record BoxDelivered(int box) implements CarryEvent {}

  /** A box was set down on the way, by a worker that was left alone with it. */
  record BoxSetDown(int box, Vec2 place) implements CarryEvent {}

  /** The map has no path for a worker to a box and on to its target, so it did not set out. */
  record BoxUnreachable(String worker) implements CarryEvent {}

  /** A robot is charged. */
  record RobotCharged(String robot) implements CarryEvent {}

  /** A robot stands at its parking place. */
  record RobotParked(String robot) implements CarryEvent {}

  /** A worker is not heard any more. */
  record WorkerLost(String worker) implements CarryEvent {}

  /**
   * A worker is heard again, or for the first time by a supervisor that has just started.
   *
   * @param held the box in its arm
   * @param partner who holds it too
   */
  record WorkerBack(String worker, @Nullable Integer held, @Nullable String partner)
      implements CarryEvent {}
}
