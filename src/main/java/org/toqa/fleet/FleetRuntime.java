package org.toqa.fleet;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * What the agents take of the machine that they run on: threads, and a clock for how long it
 * computes. A test hands in its own, so that neither decides what comes out.
 */
public interface FleetRuntime {

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
        public long nanoTime() {
          return System.nanoTime();
        }
      };

  /** What runs the agents; empty: the threads of their system. */
  Optional<Executor> agentExecutor();

  /** Does one thing after the other; its owner shuts it down. */
  ExecutorService serialExecutor(String name);

  /** Does things beside each other, each on a thread of its own. */
  Executor threadPerTaskExecutor(String name);

  /** Nanoseconds, for limits of computing and of answers. */
  long nanoTime();

  /** Nanoseconds of real time, by which it is watched that agents go on; it never jumps. */
  default long monotonicNanos() {
    return System.nanoTime();
  }
}
