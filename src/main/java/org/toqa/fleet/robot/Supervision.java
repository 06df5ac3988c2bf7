package org.toqa.fleet.robot;

import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.SupervisorStrategy;
import org.apache.pekko.actor.typed.javadsl.Behaviors;

/** How every agent is supervised. */
public final class Supervision {
  private Supervision() {}

  /** A surprise in one message is logged, and the agent takes the next one. */
  public static <T> Behavior<T> resuming(Behavior<T> agent) {
    return Behaviors.supervise(agent).onFailure(SupervisorStrategy.resume());
  }
}
