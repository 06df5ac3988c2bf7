package org.toqa.agent;

import java.util.concurrent.locks.LockSupport;

/**
 * Ticks a daemon by the machine's monotonic clock, or by one that goes faster, on the thread that
 * calls {@link #run}, when its {@link TickSchedule} says.
 */
final class RealTimeLoop implements Runnable {

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
    TickSchedule schedule = new TickSchedule(daemon, time());
    while (running && !own.isInterrupted()) {
      long now = time();
      long wait = schedule.nanosUntilDue(now);
      if (wait > 0) {
        LockSupport.parkNanos((long) (wait / timeFactor));
      } else {
        schedule.tick(now);
      }
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
