package org.toqa.lab.record;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.persistence.StoreException;

/**
 * The runs of a site, one after the other.
 *
 * <ol>
 *   <li>{@link #start} stores a run and queues it, or says that there is no room.
 *   <li>A thread takes the runs in their order. Of all sites together one runs at a time.
 *   <li>What it gives is stored. Whoever watches asks {@link #progress}; nobody need to.
 * </ol>
 *
 * <p>While the store is away what is to be stored is tried again. What waited when the server ended
 * is taken up by the next one; what ran is broken off. Any thread may call it.
 */
public final class Laboratory implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Laboratory.class);

  /** More runs are not kept: somebody deletes old ones. */
  public static final int MOST_KEPT = 200;

  /** More runs do not wait. */
  public static final int MOST_WAITING = 10;

  /** Between two tries while the store is away. */
  private static final Duration STORE_PAUSE = Duration.ofSeconds(2);

  /** For the process of a run to end, and for a store that does not answer. */
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(60);

  private final LabRunStore store;
  private final ExperimentRunner runner;
  private final Semaphore slot;
  private final InstantSource clock;
  private final BlockingQueue<Long> waiting = new LinkedBlockingQueue<>();
  private final Thread thread;
  private volatile @Nullable Current current;
  private volatile boolean isClosed;

  /** What an order is answered with. */
  public sealed interface Ordered {
    record Queued(LabRun run) implements Ordered {}

    /** {@link #MOST_WAITING} runs wait already. */
    record QueueFull() implements Ordered {}

    /** {@link #MOST_KEPT} runs are kept already. */
    record ArchiveFull() implements Ordered {}
  }

  /**
   * How far a run is.
   *
   * @param share done, 0 to 1
   * @param step what is done now, in English
   */
  public record Progress(double share, String step) {}

  /** The run that goes on now. */
  private static final class Current {
    final long id;
    volatile Progress progress = new Progress(0, "");
    volatile boolean isStopped;

    /** It is, and is only to be stored yet. */
    volatile boolean isOver;

    Current(long id) {
      this.id = id;
    }
  }

  /**
   * Goes on with what waits in the store.
   *
   * @param slot with one permit, which all sites of the server share
   */
  public Laboratory(
      LabRunStore store, ExperimentRunner runner, Semaphore slot, InstantSource clock) {
    this.store = store;
    this.runner = runner;
    this.slot = slot;
    this.clock = clock;
    store.breakOff(clock.instant());
    List<LabRun> kept = new ArrayList<>(store.runs());
    Collections.reverse(kept);
    kept.stream()
        .filter(run -> run.state() == LabRunState.QUEUED)
        .forEach(run -> waiting.add(run.id()));
    this.thread = Thread.ofVirtual().name("laboratory").start(this::work);
  }

  /** Queues a run, which was checked. */
  public synchronized Ordered start(LabOrder order, String user) {
    List<LabRun> kept = store.runs();
    if (kept.stream().filter(run -> run.state() == LabRunState.QUEUED).count() >= MOST_WAITING) {
      return new Ordered.QueueFull();
    }
    if (kept.size() >= MOST_KEPT) {
      return new Ordered.ArchiveFull();
    }
    LabRun run = store.add(order, user, clock.instant().truncatedTo(ChronoUnit.MILLIS));
    waiting.add(run.id());
    return new Ordered.Queued(run);
  }

  /** Ends a run early, within seconds; false: it is over. */
  public boolean stop(long id) {
    Current running = current;
    if (running != null && running.id == id) {
      running.isStopped = true;
      return !running.isOver;
    }
    return store
        .run(id)
        .filter(run -> run.state() == LabRunState.QUEUED)
        .map(run -> store.end(id, LabRunState.STOPPED, null, clock.instant()))
        .orElse(false);
  }

  /** Of the run that goes on now; empty: that one does not. */
  public Optional<Progress> progress(long id) {
    Current running = current;
    return running == null || running.id != id ? Optional.empty() : Optional.of(running.progress);
  }

  /** All that is kept. */
  public LabRunStore store() {
    return store;
  }

  private void work() {
    try {
      while (!isClosed) {
        long id = waiting.take();
        try {
          complete(new Current(id));
        } catch (StoreException e) {
          log.warn("The store refuses run {} of the laboratory.", id, e);
        } finally {
          current = null;
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void complete(Current now) throws InterruptedException {
    current = now;
    Optional<ExperimentRunner.Outcome> outcome = tryAgain(now.id, () -> run(now));
    if (outcome.isEmpty()) {
      return;
    }
    now.isOver = true;
    Instant at = clock.instant();
    try {
      tryAgain(now.id, () -> keep(now.id, outcome.get(), at));
    } catch (StoreException e) {
      log.warn("What run {} of the laboratory gave is refused.", now.id, e);
      tryAgain(now.id, () -> store.end(now.id, LabRunState.FAILED, e.getMessage(), at));
    }
  }

  /** What needs the store. */
  private interface Step<T> {
    T take() throws InterruptedException;
  }

  /**
   * Takes a step as soon as the store answers, without the slot meanwhile.
   *
   * @throws InterruptedException this is closed; the next start breaks off what the store holds for
   *     running
   * @throws StoreException it never would
   */
  private <T> T tryAgain(long id, Step<T> step) throws InterruptedException {
    boolean isTold = false;
    while (true) {
      try {
        return step.take();
      } catch (StoreException e) {
        if (e.isRefusal() || e.kind() == StoreException.Kind.TOO_SLOW) {
          throw e;
        }
        if (!isTold) {
          log.warn(
              "Run {} of the laboratory is not stored, which is tried again: {}", id, e.toString());
          isTold = true;
        }
        if (isClosed) {
          throw new InterruptedException();
        }
        Thread.sleep(STORE_PAUSE);
      }
    }
  }

  /** Empty: it waits no more. */
  private Optional<ExperimentRunner.Outcome> run(Current now) throws InterruptedException {
    slot.acquire();
    try {
      Optional<LabRun> run = store.run(now.id);
      if (run.isEmpty() || !begin(run.get())) {
        return Optional.empty();
      }
      return Optional.of(
          runner.run(
              run.get().order(),
              (share, step) -> now.progress = new Progress(share, step),
              () -> now.isStopped));
    } catch (InterruptedException e) {
      breakOff(now.id);
      throw e;
    } catch (StoreException e) {
      throw e;
    } catch (RuntimeException e) {
      log.warn("Run {} of the laboratory failed.", now.id, e);
      return Optional.of(new ExperimentRunner.Outcome.Failed(String.valueOf(e)));
    } finally {
      slot.release();
    }
  }

  /** A run that is found running was begun by an earlier try, whose answer was lost. */
  private boolean begin(LabRun run) {
    return run.state() == LabRunState.RUNNING || store.begin(run.id(), clock.instant());
  }

  /** The next start does it where the store does not answer. */
  private void breakOff(long id) {
    try {
      store.end(id, LabRunState.BROKEN_OFF, null, clock.instant());
    } catch (StoreException e) {
      log.warn("Run {} of the laboratory is broken off by the next start: {}", id, e.toString());
    }
  }

  private boolean keep(long id, ExperimentRunner.Outcome outcome, Instant at) {
    switch (outcome) {
      case ExperimentRunner.Outcome.Done(LabResult result) -> store.complete(id, result, at);
      case ExperimentRunner.Outcome.Stopped _ -> store.end(id, LabRunState.STOPPED, null, at);
      case ExperimentRunner.Outcome.Failed(String detail) ->
          store.end(id, LabRunState.FAILED, detail, at);
    }
    return true;
  }

  /** The run that goes on is broken off; those that wait go on after the next start. */
  @Override
  public void close() {
    isClosed = true;
    thread.interrupt();
    try {
      if (!thread.join(CLOSE_LIMIT)) {
        log.warn("The laboratory does not end; the server ends without it.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
