package org.toqa.app.server;

import java.time.Duration;
import java.time.Instant;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.sim.Participant;
import org.toqa.sim.VirtualClock;

/**
 * A fleet by the clock of its world. A simulated world waits where planning takes longer than its
 * time does: robots would else stand where real ones drive on. Real robots are not waited for.
 */
record FleetInWorld(AgentFleet fleet, VirtualClock clock, boolean isSimulated)
    implements Participant {
  /** As long as a robot's released path is driven on in any case. */
  private static final Duration LATEST = Duration.ofSeconds(1);

  @Override
  public void tick(long nanos) {
    fleet.tick(clock.instant());
  }

  @Override
  public boolean isReady(long nanos) {
    Instant behind = clock.instant().minus(LATEST);
    return !isSimulated || !fleet.floorTime().isBefore(behind);
  }

  @Override
  public String toString() {
    return "the fleet, which is at " + fleet.floorTime();
  }
}
