package org.toqa.agent;

import org.toqa.agent.chassis.Chassis;

/**
 * When a daemon is ticked: every {@link Chassis#period}; a robot at rest less often, and at once
 * when a message comes. Times are nanoseconds on the daemon's monotonic clock. For the thread of
 * the ticks.
 */
public final class TickSchedule {

  /** Three for each state that it reports, and well below what its microcontroller endures. */
  private static final long AT_REST_PERIOD_NANOS = 66_666_666;

  private final Daemon daemon;
  private long period;
  private long next;

  /**
   * @param first when the first tick is due
   */
  public TickSchedule(Daemon daemon, long first) {
    this.daemon = daemon;
    period = daemon.period().toNanos();
    next = first;
  }

  /** How long until the next tick is due, if no message comes; 0 or less where it is due now. */
  public long nanosUntilDue(long now) {
    return isCalled() ? 0 : next - now;
  }

  private boolean isCalled() {
    return period == AT_REST_PERIOD_NANOS && daemon.hasPendingMessages();
  }

  /** Ticks the daemon. */
  public void tick(long now) {
    boolean isCalled = isCalled();
    daemon.tick(now);
    period = daemon.isAtRest() ? AT_REST_PERIOD_NANOS : daemon.period().toNanos();
    // after a stall the ticks that were missed are not made up for
    next = isCalled || now - next > period ? now + period : next + period;
  }
}
