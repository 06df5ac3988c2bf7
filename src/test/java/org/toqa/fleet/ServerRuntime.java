package org.toqa.fleet;

import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;

/** The threads and the clock of a server, for tests that change one of them. */
public abstract class ServerRuntime implements FleetRuntime {
  @Override
  public Optional<Executor> agentExecutor() {
    return USUAL.agentExecutor();
  }

  @Override
  public ExecutorService serialExecutor(String name) {
    return USUAL.serialExecutor(name);
  }

  @Override
  public Executor threadPerTaskExecutor(String name) {
    return USUAL.threadPerTaskExecutor(name);
  }

  @Override
  public Executor boundedExecutor(String name, int threads) {
    return USUAL.boundedExecutor(name, threads);
  }

  @Override
  public long nanoTime() {
    return USUAL.nanoTime();
  }
}
