package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ManualOrder;

/** Who drives a robot by hand, if anybody does. Only {@link ManualDriveHandler} changes it. */
final class ManualControl {
  private @Nullable Session session;

  /**
   * @param number of the last order
   * @param heardAt when that came, of the time that ticks bring
   * @param isReady whether the robot has stood since, so that all that it drives is by hand
   */
  record Session(UUID lease, String user, long number, Instant heardAt, boolean isReady) {

    Session renewed(ManualOrder order, Instant now) {
      return new Session(lease, user, order.number(), now, isReady);
    }

    Session ready() {
      return new Session(lease, user, number, heardAt, true);
    }
  }

  /** Null: it drives by itself. */
  @Nullable Session session() {
    return session;
  }

  boolean isActive() {
    return session != null;
  }

  /** The name of who drives it; null: it drives by itself. */
  @Nullable String driver() {
    return session == null ? null : session.user();
  }

  /**
   * @param next null: it drives by itself again
   */
  void setSession(@Nullable Session next) {
    session = next;
  }
}
