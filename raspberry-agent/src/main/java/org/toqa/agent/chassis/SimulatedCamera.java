package org.toqa.agent.chassis;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.CameraView;

/** Cameras on a simulated body, which look all round five times a second. */
final class SimulatedCamera {
  private static final long PERIOD_NANOS = 200_000_000;

  private final Surroundings surroundings;
  private @Nullable CameraView view;
  private long nextNanos = Long.MIN_VALUE;

  SimulatedCamera(Surroundings surroundings) {
    this.surroundings = surroundings;
  }

  /**
   * @param from where the body really is, map frame
   * @return null: there are none, or they are blind
   */
  @Nullable CameraView update(Vec2 from, long nanos) {
    if (nanos >= nextNanos) {
      nextNanos = nanos + PERIOD_NANOS;
      view = surroundings.view(from);
    }
    return view;
  }
}
