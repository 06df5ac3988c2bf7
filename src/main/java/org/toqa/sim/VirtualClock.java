package org.toqa.sim;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The one clock of a simulated world. It goes in steps of 20 ms: in each step every participant
 * that is due has its tick, in the order in which they were added, and only then does time go on.
 * So a slow machine slows the world and trips no timer of it. Who is never ready cannot hold it up
 * for good: after half a minute it goes on without waiting for that one, see {@link Inhabitant}.
 *
 * <p>Either {@link #start} lets it run by itself, so many times faster than real time as the
 * machine can keep up with, or a test moves it by {@link #advance}.
 */
public final class VirtualClock implements InstantSource, AutoCloseable {

  /** What the world's time advances by at once: 20 ms, a tick of the daemon. */
  public static final Duration STEP = Duration.ofMillis(20);

  private static final Logger log = LoggerFactory.getLogger(VirtualClock.class);

  /** Real time for which participants may block the world without a pause. */
  private static final Duration MAX_HOLD = Duration.ofSeconds(5);

  private static final long CLOSE_TIMEOUT_MS = 5_000;

  /** The world may be held up for {@link #MAX_HOLD} in each of the steps to a tick of the fleet. */
  private static final long STANDS_AFTER_NANOS = Duration.ofMinutes(1).toNanos();

  /** The world gives up real time that it is behind by more than this. */
  private static final long MAX_LAG_NANOS = 100_000_000;

  private final Instant epoch;
  private final double speed;
  private final long maxHoldNanos;
  private final List<Inhabitant> inhabitants = new CopyOnWriteArrayList<>();
  private final Object step = new Object();
  private final Thread thread;
  private volatile long nanos;
  private volatile boolean closed;
  private volatile boolean hasLostParticipant;
  private final CompletableFuture<Throwable> broken = new CompletableFuture<>();

  /** Of real time: when the last step was done. */
  private volatile long steppedAt;

  /**
   * @param epoch the world's time at its start
   * @param speed how many times faster than real time it goes
   * @throws IllegalArgumentException if that is not above 0 and finite
   */
  public VirtualClock(Instant epoch, double speed) {
    this(epoch, speed, MAX_HOLD);
  }

  /**
   * @param maxHold of real time, for which participants may block the world without a pause
   */
  VirtualClock(Instant epoch, double speed, Duration maxHold) {
    if (!(speed > 0) || Double.isInfinite(speed)) {
      throw new IllegalArgumentException("The speed must be positive, not " + speed + ".");
    }
    this.epoch = epoch;
    this.speed = speed;
    this.maxHoldNanos = maxHold.toNanos();
    thread = Thread.ofPlatform().name("virtual-clock").daemon().unstarted(this::run);
  }

  /** Nanoseconds since the world's start, monotonic. */
  public long nanos() {
    return nanos;
  }

  @Override
  public Instant instant() {
    return epoch.plusNanos(nanos);
  }

  /**
   * From now on the participant has a tick whenever the world's time is a multiple of the period.
   *
   * @param period of the world's time; a multiple of {@link #STEP}, above 0
   * @throws IllegalArgumentException if it is not
   */
  public void add(Participant participant, Duration period) {
    if (period.toNanos() <= 0 || period.toNanos() % STEP.toNanos() != 0) {
      throw new IllegalArgumentException("The period " + period + " is no multiple of " + STEP);
    }
    inhabitants.add(new Inhabitant(participant, period.toNanos()));
  }

  /** When this returns, the participant has no running tick and will have none. */
  public void remove(Participant participant) {
    synchronized (step) {
      inhabitants.removeIf(inhabitant -> inhabitant.participant() == participant);
    }
  }

  /**
   * Whether the world goes on, all that was added included: no participant failed, and a clock that
   * was started has made a step within a minute of real time.
   */
  public boolean isSound() {
    boolean stands =
        thread.getState() != Thread.State.NEW
            && !closed
            && System.nanoTime() - steppedAt > STANDS_AFTER_NANOS;
    return !hasLostParticipant && !broken.isDone() && !stands;
  }

  /** Completes with the error that ended a running clock: the world's time stands for ever. */
  public CompletionStage<Throwable> whenBroken() {
    return broken;
  }

  /** Lets the world run. */
  public void start() {
    steppedAt = System.nanoTime();
    thread.start();
  }

  /**
   * Moves the world on, ready or not; for a clock that was not started.
   *
   * @param time of the world; rounded up to whole steps
   */
  public void advance(Duration time) {
    long end = nanos + time.toNanos();
    while (nanos < end) {
      advanceOneStep();
    }
  }

  /** Stops the world; when this returns, no tick is running. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    try {
      thread.join(CLOSE_TIMEOUT_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void run() {
    try {
      runUntilClosed();
    } catch (RuntimeException | Error e) {
      broken.complete(e); // before anything else, which may need memory
      log.error("The clock has ended.", e);
    }
  }

  private void runUntilClosed() {
    long stepNanos = Math.round(STEP.toNanos() / speed);
    long due = System.nanoTime();
    long heldSince = due;
    while (!closed) {
      long now = System.nanoTime();
      if (now < due) {
        LockSupport.parkNanos(due - now);
        continue;
      }
      boolean isReady = isReady();
      if (!isReady && now - heldSince < maxHoldNanos) {
        LockSupport.parkNanos(STEP.toNanos() / 20);
        continue;
      }
      for (Inhabitant inhabitant : inhabitants) { // at every step
        inhabitant.goOn(nanos, !isReady);
      }
      advanceOneStep();
      heldSince = now;
      steppedAt = now;
      due = Math.max(due + stepNanos, now - MAX_LAG_NANOS);
    }
  }

  /** Whether no participant holds the world up. */
  public boolean isReady() {
    for (Inhabitant inhabitant : inhabitants) { // at every step
      if (inhabitant.isAwaited(nanos)) {
        return false;
      }
    }
    return true;
  }

  private void advanceOneStep() {
    synchronized (step) {
      long next = nanos + STEP.toNanos();
      nanos = next;
      for (Inhabitant inhabitant : inhabitants) {
        if (inhabitant.isDue(next)) {
          tick(inhabitant, next);
        }
      }
    }
  }

  /** A surprise in one participant ends that one, never the world. */
  private void tick(Inhabitant inhabitant, long now) {
    try {
      inhabitant.participant().tick(now);
    } catch (RuntimeException e) {
      log.error("{} failed and takes no part any more.", inhabitant.participant(), e);
      inhabitants.remove(inhabitant);
      hasLostParticipant = true;
    }
  }
}
