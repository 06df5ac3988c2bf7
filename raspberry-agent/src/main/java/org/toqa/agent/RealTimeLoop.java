package org.toqa.agent;

import java.util.concurrent.locks.LockSupport;

/**
 * Ticks a daemon by the machine's monotonic clock, or by one that goes faster, on the thread that
 * calls {@link #run}.
 */
final class RealTimeLoop implements Runnable {

  private static final long PERIOD = Daemon.TICK.toNanos();

  private final Daemon daemon;
  private final double speed;
  private final long start = System.nanoTime();
  private volatile boolean running = true;

  /**
   * @param speed how many times faster than real time the daemon lives
   */
  RealTimeLoop(Daemon daemon, double speed) {
    this.daemon = daemon;
    this.speed = speed;
  }

  @Override
  public void run() {
    long next = time();
    while (running && !Thread.currentThread().isInterrupted()) {
      long now = time();
      if (now - next < 0) {
        LockSupport.parkNanos((long) ((next - now) / speed));
        continue;
      }
      daemon.tick(now);
      // after a stall the ticks that were missed are not made up for
      next = now - next > PERIOD ? now + PERIOD : next + PERIOD;
    }
  }

  private long time() {
    return start + (long) ((System.nanoTime() - start) * speed);
  }

  /** Ends {@link #run} after the tick under way. */
  void stop() {
    running = false;
  }
}
