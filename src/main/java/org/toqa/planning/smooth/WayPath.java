package org.toqa.planning.smooth;

import java.util.List;
import org.toqa.geometry.Vec2;

/**
 * A free path of straight lines, and how it became as short as it is.
 *
 * @param points metres, map frame, from start to goal; one where these are the same
 * @param progress each time that a shorter path was found, in their order
 */
public record WayPath(List<Vec2> points, List<Progress> progress) {

  /**
   * A shorter path was found.
   *
   * @param iteration how many iterations of tree and swarm were done
   * @param length of the path, metres
   */
  public record Progress(long iteration, double length) {}

  public WayPath {
    points = List.copyOf(points);
    progress = List.copyOf(progress);
  }

  /** Metres along it. */
  public double length() {
    return Vec2.lengthOf(points);
  }
}
