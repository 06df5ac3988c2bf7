package org.toqa.agent.chassis;

import org.toqa.geometry.Pose;

/** Who sees where a simulated body really is: what no robot knows of itself. */
@FunctionalInterface
public interface Onlooker {

  Onlooker NOBODY = truth -> {};

  /**
   * Called at every exchange, by the body's thread.
   *
   * @param truth map frame
   */
  void sees(Pose truth);
}
