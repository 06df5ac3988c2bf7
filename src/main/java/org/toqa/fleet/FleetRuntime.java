package org.toqa.fleet;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * What the agents take of the machine that they run on: threads, and a clock for how long it
 * computes. A test hands in its own, so that neither decides what comes out.
 */
public interface FleetRuntime {
  /** Until an idle thread ends. */
  int IDLE_SECONDS = 10;

  /** That of a server. */
  FleetRuntime USUAL =
      new FleetRuntime() {
        @Override
        public Optional<Executor> agentExecutor() {
          return Optional.empty();
        }

        @Override
        public ExecutorService serialExecutor(String name) {
          return Executors.newSingleThreadExecutor(
              Thread.ofPlatform().daemon().name(name).factory());
        }

        @Override
        public Executor threadPerTaskExecutor(String name) {
          return work -> Thread.ofVirtual().name(name).start(work);
        }

        @Override
        public Executor boundedExecutor(String name, int threads) {
          ThreadPoolExecutor executor =
              new ThreadPoolExecutor(
                  threads,
                  threads,
                  IDLE_SECONDS,
                  TimeUnit.SECONDS,
                  new LinkedBlockingQueue<>(),
                  Thread.ofPlatform().daemon().name(name).factory());
          executor.allowCoreThreadTimeOut(true);
          return executor;
        }

        @Override
        public long nanoTime() {
          return System.nanoTime();
        }
      };

  /** What runs the agents; empty: the threads of their system. */
  Optional<Executor> agentExecutor();

  /**
   * What runs as an agent: the usual one, where nobody puts another in its place.
   *
   * @param name such as {@code robot-r1}
   */
  default <B> B agent(String name, B usual) {
    return usual;
  }

  /** Does one thing after the other; its owner shuts it down. */
  ExecutorService serialExecutor(String name);

  /** Does things beside each other, each on a thread of its own. */
  Executor threadPerTaskExecutor(String name);

  /** Does so many things beside each other; others wait. Its threads end when they are idle. */
  Executor boundedExecutor(String name, int threads);

  /** Nanoseconds, for limits of computing and of answers. */
  long nanoTime();

  /**
   * The paths of several robots of a floor were planned together, or no plan was found.
   *
   * @param nanos of real time that it took
   */
  default void recordPlanning(long nanos) {}

  /** Nanoseconds of real time, by which it is watched that agents go on; it never jumps. */
  default long monotonicNanos() {
    return System.nanoTime();
  }
}
