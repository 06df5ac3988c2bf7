package org.toqa.motion;

import org.jspecify.annotations.Nullable;

/**
 * Room beside a path that is a robot's own for a while, to drive round what it sees there.
 *
 * @param from the first segment of the path beside which it is, counted from 0
 * @param to the first one beside which it is not any more
 * @param left metres that the robot's middle may be to the left of its path
 * @param right metres that it may be to the right
 * @param zone that the robot may drive through as it finds its way, from where segment {@code from}
 *     begins to where segment {@code to} does; null: none
 */
public record PassingRoom(int from, int to, double left, double right, @Nullable FreeZone zone) {

  /** Beside the path. */
  public PassingRoom(int from, int to, double left, double right) {
    this(from, to, left, right, null);
  }
}
