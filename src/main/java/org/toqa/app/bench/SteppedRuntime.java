package org.toqa.app.bench;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.concurrent.AbstractExecutorService;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.toqa.fleet.FleetRuntime;

/**
 * Simulated time in which one thread does all that agents do and all that is due: the same events
 * bring the same run. Nothing takes simulated time but what is said to: a store answers after a
 * while, plans are made after another, and so is what agents hand to other threads. Limits of
 * planning are of real time, as in a server, or of a time that counts how often it was looked at,
 * so that the machine's speed decides nothing.
 */
final class SteppedRuntime implements FleetRuntime, InstantSource {
  private static final Instant EPOCH = Instant.parse("2026-01-01T08:00:00Z");

  /** What agents hand to other threads, as checks of orders. */
  private static final Duration OTHER_THREADS = Duration.ofMillis(20);

  private static final long PATIENCE_MS = 10;

  private final long storeNanos;
  private final Duration planning;
  private final long lookNanos;
  private final BlockingQueue<Runnable> turns = new LinkedBlockingQueue<>();
  private final PriorityQueue<Event> events = new PriorityQueue<>();
  private final List<Double> planMillis = new ArrayList<>();
  private long nanos;
  private long count;
  private long looks;
  private long agentNanos;

  /**
   * @param at nanoseconds since the start
   * @param number what was said first is done first
   */
  private record Event(long at, long number, Runnable work) implements Comparable<Event> {
    @Override
    public int compareTo(Event other) {
      return at == other.at ? Long.compare(number, other.number) : Long.compare(at, other.at);
    }
  }

  /**
   * @param store until a change is stored; of changes of one agent none overtakes another
   * @param planning until a plan is made that an agent asks for
   * @param look what planning is taken to last from one look at the time to the next; zero: its
   *     limits are of real time
   */
  SteppedRuntime(Duration store, Duration planning, Duration look) {
    this.planning = planning;
    storeNanos = store.toNanos();
    lookNanos = look.toNanos();
  }

  /** Nanoseconds of simulated time since the start. */
  long nanos() {
    return nanos;
  }

  @Override
  public Instant instant() {
    return EPOCH.plusNanos(nanos);
  }

  /** Real nanoseconds that the agents have computed, all together. */
  long agentNanos() {
    return agentNanos;
  }

  /** Forgets what was measured so far. */
  void resetMeasurements() {
    agentNanos = 0;
    planMillis.clear();
  }

  /** How long each plan of several robots took, milliseconds of real time. */
  double[] planMillis() {
    return planMillis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  /** Has something done so much later. */
  void schedule(Duration delay, Runnable work) {
    scheduleAt(nanos + delay.toNanos(), work);
  }

  private void scheduleAt(long at, Runnable work) {
    events.add(new Event(at, count++, work));
  }

  /**
   * Does all that is due until then, in order.
   *
   * @param end nanoseconds since the start
   */
  void advanceTo(long end) {
    for (Event next = events.peek(); next != null && next.at() <= end; next = events.peek()) {
      events.remove();
      nanos = next.at();
      next.work().run();
      runAgents();
    }
    nanos = end;
  }

  /**
   * Lets the agents do all that they have to.
   *
   * @return nanoseconds of real time that the longest turn of one of them took
   */
  long runAgents() {
    long begin = System.nanoTime();
    long longest = 0;
    long last = begin;
    for (Runnable turn = turns.poll(); turn != null; turn = turns.poll()) {
      turn.run();
      long end = System.nanoTime();
      longest = Math.max(longest, end - last);
      last = end;
    }
    agentNanos += last - begin;
    return longest;
  }

  /** Lets the agents go on until another thread has waited for something of theirs. */
  <T> T await(Supplier<T> waiting) {
    CompletableFuture<T> result =
        CompletableFuture.supplyAsync(waiting, Thread::startVirtualThread);
    try {
      while (!result.isDone()) {
        Runnable turn = turns.poll(PATIENCE_MS, TimeUnit.MILLISECONDS);
        if (turn != null) {
          turn.run();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("It was interrupted.", e);
    }
    return result.join();
  }

  @Override
  public Optional<Executor> agentExecutor() {
    return Optional.of(turns::add);
  }

  @Override
  public ExecutorService serialExecutor(String name) {
    return new DelayedExecutor();
  }

  @Override
  public Executor threadPerTaskExecutor(String name) {
    return work -> schedule(OTHER_THREADS, work);
  }

  @Override
  public Executor boundedExecutor(String name, int threads) {
    return work -> schedule(planning, work);
  }

  @Override
  public long nanoTime() {
    return lookNanos == 0 ? System.nanoTime() : ++looks * lookNanos;
  }

  @Override
  public void recordPlanning(long took) {
    planMillis.add(took / 1e6);
  }

  /** A writer to the store. What it has not done when it is closed is never done. */
  private final class DelayedExecutor extends AbstractExecutorService {
    private long last;
    private boolean shut;

    @Override
    public void execute(Runnable change) {
      last = Math.max(last, nanos + storeNanos);
      scheduleAt(last, change);
    }

    @Override
    public void shutdown() {
      shut = true;
    }

    @Override
    public List<Runnable> shutdownNow() {
      shut = true;
      return List.of();
    }

    @Override
    public boolean isShutdown() {
      return shut;
    }

    @Override
    public boolean isTerminated() {
      return shut;
    }

    @Override
    public boolean awaitTermination(long timeout, TimeUnit unit) {
      return true;
    }
  }
}
