package org.toqa.allocation;

import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;

/**
 * How long the paths on a floor are. The path back may be longer, where some are driven one way.
 */
@FunctionalInterface
public interface PathLengths {

  /** Straight lines, through whatever is in between. */
  PathLengths STRAIGHT = (place, diameter) -> place::distanceTo;

  /**
   * The lengths of a robot's paths to one place from others, metres; infinite where there is none
   * that is wide enough for it. To be asked for once for many others.
   *
   * @param place metres, map frame
   * @param diameter of the robot, metres
   */
  ToDoubleFunction<Vec2> lengthsTo(Vec2 place, double diameter);

  /** The length of its path from one place to another, metres; infinite likewise. */
  default double length(Vec2 from, Vec2 to, double diameter) {
    return lengthsTo(to, diameter).applyAsDouble(from);
  }
}
