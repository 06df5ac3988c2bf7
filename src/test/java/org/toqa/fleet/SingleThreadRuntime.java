package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.AbstractExecutorService;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.javadsl.Behaviors;

/**
 * All that a fleet does on one thread, in the order in which it came up: the same events bring the
 * same run. Whoever brings an event waits until all that follows from it is done.
 */
final class SingleThreadRuntime implements FleetRuntime, AutoCloseable {
  /** For a fleet that does not come to rest at all; nothing else depends on it. */
  private static final Duration HANGS_AFTER = Duration.ofSeconds(60);

  /** What computing is taken to last, so that its limits are the same on every machine. */
  private static final long NANOS_A_LOOK = 1_000;

  private static final long TURNS_TO_A_WAIT = 100;
  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

  private final BlockingQueue<Runnable> work = new LinkedBlockingQueue<>();
  private final AtomicLong looks = new AtomicLong();
  private final AtomicLong passed = new AtomicLong();
  private final Thread thread = Thread.ofPlatform().daemon().name("fleet").start(this::run);

  /** Whether what agents do is looked at: neither while they are made, nor while they end. */
  private volatile boolean isWatching;

  /** What agents did while it was, and how often they waited for anything. */
  private final AtomicLong agentTurns = new AtomicLong();

  private final AtomicLong agentWaits = new AtomicLong();

  /** By the name of an agent. */
  private final Map<String, StrangeBidder.Habit> habits = new ConcurrentHashMap<>();

  /** What agents did meanwhile that waits for a disk or another machine where those are slow. */
  private final Queue<String> slowCalls = new ConcurrentLinkedQueue<>();

  /** For its own thread alone: whether an agent runs on it and is looked at. */
  private boolean isWatchedTurn;

  /** Guarded by this: what was handed in and is not done. */
  private long open;

  /** Guarded by this: the executors whose turns do not come, and the turns that wait for that. */
  private Predicate<String> isStopped = name -> false;

  private final List<Turn> stoppedTurns = new ArrayList<>();

  private final Set<String> serialExecutors = ConcurrentHashMap.newKeySet();

  private record Turn(String name, Runnable turn) {}

  private void run() {
    try {
      while (true) {
        Runnable next = work.take();
        try {
          next.run();
        } catch (RuntimeException e) {
          Thread current = Thread.currentThread();
          current.getUncaughtExceptionHandler().uncaughtException(current, e);
        } finally {
          done();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void add(Runnable next) {
    synchronized (this) {
      open++;
    }
    work.add(next);
  }

  private synchronized void done() {
    open--;
    notifyAll();
  }

  /** Waits until nothing is left to do. */
  synchronized void awaitQuiescence() throws InterruptedException {
    long end = System.nanoTime() + HANGS_AFTER.toNanos();
    while (open > 0) {
      long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
      if (left <= 0) {
        throw new IllegalStateException("The fleet does not come to rest.");
      }
      wait(left);
    }
  }

  @Override
  public Optional<Executor> agentExecutor() {
    return Optional.of(work -> add(() -> runAgent(work)));
  }

  /** Time is not measured: a wait is one on a machine of any speed. */
  private void runAgent(Runnable work) {
    if (!isWatching) {
      work.run();
      return;
    }
    long before = waits();
    isWatchedTurn = true;
    try {
      work.run();
    } finally {
      isWatchedTurn = false;
      agentWaits.addAndGet(waits() - before);
      agentTurns.incrementAndGet();
    }
  }

  @Override
  @SuppressWarnings("unchecked") // an agent is a behavior
  public <B> B agent(String name, B usual) {
    return (B)
        Behaviors.intercept(
            () ->
                new StrangeBidder<>(
                    name.replaceFirst("^robot-", ""),
                    () -> habits.getOrDefault(name, StrangeBidder.Habit.USUAL)),
            (Behavior<Object>) usual);
  }

  /** From now on the robot's agent takes part in negotiations so. */
  void setBidding(String robot, StrangeBidder.Habit habit) {
    habits.put("robot-" + robot, habit);
  }

  /**
   * From now on agents may wait for nothing, or, where they are made or end, again for something.
   */
  void setWatching(boolean isWatched) {
    isWatching = isWatched;
  }

  /** How often this thread has slept or waited for another one. */
  private static long waits() {
    return THREADS.getThreadInfo(Thread.currentThread().threadId()).getWaitedCount();
  }

  /** Something was called that may take long; no agent may do so. */
  void recordSlowCall(String what) {
    if (Thread.currentThread() == thread && isWatchedTurn) {
      slowCalls.add(what);
    }
  }

  /**
   * No agent sleeps, or waits for a file, a database or an answer, in what it does again and again.
   * Another thread that logs at the same moment may hold one up, in one turn of a hundred.
   */
  void assertAgentsNeverWaited() {
    assertTrue(
        agentWaits.get() <= agentTurns.get() / TURNS_TO_A_WAIT,
        () -> "agents waited " + agentWaits + " times in " + agentTurns + " turns");
    assertTrue(slowCalls.isEmpty(), () -> "agents asked the store themselves: " + slowCalls);
  }

  /**
   * What some do beside the agents takes long, as with a store that does not answer: it is done
   * when they are no longer among them.
   *
   * @param executors by their names
   */
  synchronized void stop(Predicate<String> executors) {
    isStopped = executors;
    List<Turn> turns = List.copyOf(stoppedTurns);
    stoppedTurns.clear();
    turns.forEach(turn -> addTurn(turn.name(), turn.turn()));
  }

  boolean hasSerialExecutor(Predicate<String> names) {
    return serialExecutors.stream().anyMatch(names);
  }

  private synchronized void addTurn(String name, Runnable turn) {
    if (isStopped.test(name)) {
      stoppedTurns.add(new Turn(name, turn));
    } else {
      add(turn);
    }
  }

  /** Lets something happen before which nothing more is done, however much comes up. */
  void runWhileHeldUp(Runnable work) throws InterruptedException {
    awaitQuiescence();
    CountDownLatch isOver = new CountDownLatch(1);
    add(() -> awaitEnd(isOver));
    work.run();
    isOver.countDown();
    awaitQuiescence();
  }

  private static void awaitEnd(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public ExecutorService serialExecutor(String name) {
    serialExecutors.add(name);
    return new SerialExecutor(name);
  }

  @Override
  public Executor threadPerTaskExecutor(String name) {
    return work -> addTurn(name, work);
  }

  @Override
  public Executor boundedExecutor(String name, int threads) {
    return threadPerTaskExecutor(name);
  }

  @Override
  public long nanoTime() {
    return looks.incrementAndGet() * NANOS_A_LOOK + passed.get();
  }

  /** Lets that much time of {@link #nanoTime} pass. */
  void advance(Duration time) {
    passed.addAndGet(time.toNanos());
  }

  @Override
  public void close() {
    thread.interrupt();
  }

  /** One writer's turn among all others. It is closed on the fleet's thread, by its agent. */
  private final class SerialExecutor extends AbstractExecutorService {
    private final String name;
    private final Queue<Runnable> waiting = new ArrayDeque<>();
    private boolean shut;

    SerialExecutor(String name) {
      this.name = name;
    }

    @Override
    public synchronized void execute(Runnable change) {
      if (shut) {
        throw new RejectedExecutionException("It is closed.");
      }
      waiting.add(change);
      addTurn(name, this::runNext);
    }

    private boolean runNext() {
      Runnable change;
      synchronized (this) {
        change = waiting.poll();
      }
      if (change != null) {
        change.run();
      }
      return change != null;
    }

    @Override
    public synchronized void shutdown() {
      shut = true;
    }

    @Override
    public synchronized List<Runnable> shutdownNow() {
      shut = true;
      List<Runnable> left = List.copyOf(waiting);
      waiting.clear();
      return left;
    }

    @Override
    public synchronized boolean isShutdown() {
      return shut;
    }

    @Override
    public synchronized boolean isTerminated() {
      return shut && waiting.isEmpty();
    }

    @Override
    public boolean awaitTermination(long timeout, TimeUnit unit) {
      boolean isMore = true;
      while (isMore) {
        isMore = runNext();
      }
      return true;
    }
  }
}
