package org.toqa.agent;

import java.util.concurrent.locks.LockSupport;
import org.toqa.agent.chassis.Chassis;

/**
 * Ticks a daemon by the machine's monotonic clock, or by one that goes faster, on the thread that
 * calls {@link #run}. A robot at rest is ticked less often, and at once when a message comes.
 */
final class RealTimeLoop implements Runnable {

  private static final long PERIOD_NANOS = Chassis.TICK.toNanos();

  /** Three for each state that it reports, and well below what its microcontroller endures. */
  private static final long AT_REST_PERIOD_NANOS = 66_666_666;

  private final Daemon daemon;
  private final double timeFactor;
  private final long start = System.nanoTime();
  private volatile boolean running = true;

  /**
   * @param timeFactor how many times faster than real time the daemon runs
   */
  RealTimeLoop(Daemon daemon, double timeFactor) {
    this.daemon = daemon;
    this.timeFactor = timeFactor;
  }

  @Override
  public void run() {
    Thread own = Thread.currentThread();
    daemon.setMessageListener(() -> LockSupport.unpark(own));
    long period = PERIOD_NANOS;
    long next = time();
    while (running && !own.isInterrupted()) {
      long now = time();
      boolean isCalled = period == AT_REST_PERIOD_NANOS && daemon.hasPendingMessages();
      if (now - next < 0 && !isCalled) {
        LockSupport.parkNanos((long) ((next - now) / timeFactor));
        continue;
      }
      daemon.tick(now);
      period = daemon.isAtRest() ? AT_REST_PERIOD_NANOS : PERIOD_NANOS;
      // after a stall the ticks that were missed are not made up for
      next = isCalled || now - next > period ? now + period : next + period;
    }
  }

  private long time() {
    return start + (long) ((System.nanoTime() - start) * timeFactor);
  }

  /** Ends {@link #run} after the running tick. */
  void stop() {
    running = false;
  }
}
