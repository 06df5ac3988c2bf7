package org.toqa.allocation;

import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;

/** How long the ways on a floor are. The way back is as long as the way there. */
@FunctionalInterface
public interface PathLengths {

  /** As the crow flies, through whatever is in between. */
  PathLengths STRAIGHT = (place, diameter) -> place::distanceTo;

  /**
   * The lengths of a robot's ways between one place and others, metres; infinite where there is
   * none that is wide enough for it. To be asked for once for many others.
   *
   * @param place metres, map frame
   * @param diameter of the robot, metres
   */
  ToDoubleFunction<Vec2> lengthsFrom(Vec2 place, double diameter);
}
