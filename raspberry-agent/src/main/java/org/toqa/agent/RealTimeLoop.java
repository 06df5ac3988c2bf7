package org.toqa.agent;

import java.util.concurrent.locks.LockSupport;

/** Ticks a daemon by the machine's monotonic clock, on the thread that calls {@link #run}. */
final class RealTimeLoop implements Runnable {

  private static final long PERIOD = Daemon.TICK.toNanos();

  private final Daemon daemon;
  private volatile boolean running = true;

  RealTimeLoop(Daemon daemon) {
    this.daemon = daemon;
  }

  @Override
  public void run() {
    long next = System.nanoTime();
    while (running && !Thread.currentThread().isInterrupted()) {
      long now = System.nanoTime();
      if (now - next < 0) {
        LockSupport.parkNanos(next - now);
        continue;
      }
      daemon.tick(now);
      // after a stall the ticks that were missed are not made up for
      next = now - next > PERIOD ? now + PERIOD : next + PERIOD;
    }
  }

  /** Ends {@link #run} after the tick under way. */
  void stop() {
    running = false;
  }
}
