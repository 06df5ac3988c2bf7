package org.toqa.allocation;

import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;

/** How long the paths on a floor are. The path back is as long as the path there. */
@FunctionalInterface
public interface PathLengths {

  /** Straight lines, through whatever is in between. */
  PathLengths STRAIGHT = (place, diameter) -> place::distanceTo;

  /**
   * The lengths of a robot's paths between one place and others, metres; infinite where there is
   * none that is wide enough for it. To be asked for once for many others.
   *
   * @param place metres, map frame
   * @param diameter of the robot, metres
   */
  ToDoubleFunction<Vec2> lengthsFrom(Vec2 place, double diameter);
}
