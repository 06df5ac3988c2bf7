package org.toqa.fleet.manager;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.dispatch.FloorFleet;
import org.toqa.fleet.dispatch.LatestSnapshot;
import org.toqa.grid.FloorMap;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * A floor in the directory. Its agents end and others begin in their place when its map changes;
 * what is asked meanwhile waits for them. Any thread may call it; one at a time starts and ends
 * agents.
 */
final class FloorEntry {
  private static final Logger log = LoggerFactory.getLogger(FloorEntry.class);

  /** Until calls that were begun are answered. */
  private static final int DRAIN_SECONDS = 5;

  private final LatestSnapshot snapshots;
  private volatile FloorMap map;

  /** Null: while they are started. */
  private volatile @Nullable FloorFleet agents;

  /** Why they could not be started; null: they could. */
  private volatile @Nullable Sentence startFailure;

  /** Whether that was since the store did not answer. */
  private volatile boolean awaitsStore;

  /** Whom calls go to; guarded by this. */
  private Term term = new Term();

  /** While the same agents are asked. */
  private static final class Term {
    final CompletableFuture<FloorFleet> asked = new CompletableFuture<>();

    /** Completes when no call is open any more, once it is to end. */
    final CompletableFuture<Void> drained = new CompletableFuture<>();

    int open;
    boolean isEnding;
  }

  FloorEntry(FloorMap map, LatestSnapshot snapshots) {
    this.map = map;
    this.snapshots = snapshots;
  }

  String name() {
    return map.name();
  }

  FloorMap map() {
    return map;
  }

  LatestSnapshot snapshots() {
    return snapshots;
  }

  /** The agents that run; empty while they are started, or where they cannot be. */
  Optional<FloorFleet> agents() {
    return Optional.ofNullable(agents);
  }

  void ifRunning(Consumer<FloorFleet> command) {
    agents().ifPresent(command);
  }

  /** What its agents say goes wrong. */
  List<Sentence> failures() {
    Sentence failure = startFailure;
    return failure != null
        ? List.of(failure)
        : agents().map(FloorFleet::failures).orElse(List.of());
  }

  /** Whether its agents could not be started since the store did not answer. */
  boolean awaitsStore() {
    return awaitsStore;
  }

  /** Asks its agents, when they have started. */
  <T> CompletionStage<T> ask(Function<FloorFleet, CompletionStage<T>> question) {
    Term now = enter();
    return now.asked
        .exceptionally(
            failure -> {
              throw new StoreException(
                  "The floor " + name() + " does not work now; nothing was done.", failure);
            })
        .thenCompose(question)
        .whenComplete((answer, failure) -> leave(now));
  }

  /**
   * What its agents answered, or instead of them, where the floor was removed before they could be
   * asked, what is said of a floor that there is not.
   */
  static <T> CompletionStage<T> orIfRemoved(CompletionStage<T> asked, Supplier<T> otherwise) {
    return asked.exceptionallyCompose(
        failure ->
            isRemoval(failure)
                ? CompletableFuture.completedFuture(otherwise.get())
                : CompletableFuture.failedFuture(failure));
  }

  private static boolean isRemoval(Throwable failure) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      if (cause instanceof RemovedException) {
        return true;
      }
    }
    return false;
  }

  /** The same of what must not wait for a change of the map. */
  <T> CompletionStage<T> askAtOnce(Function<FloorFleet, CompletionStage<T>> question) {
    return agents().map(question).orElseGet(() -> ask(question));
  }

  private synchronized Term enter() {
    term.open++;
    return term;
  }

  private synchronized void leave(Term left) {
    left.open--;
    completeIfDrained(left);
  }

  private static void completeIfDrained(Term term) {
    if (term.isEnding && term.open == 0) {
      term.drained.complete(null);
    }
  }

  /**
   * Starts its first agents.
   *
   * @throws IllegalStateException they cannot start; whoever asks them is told so
   */
  void start(Supplier<FloorFleet> starter) {
    Term first;
    synchronized (this) {
      first = term;
    }
    start(first, starter);
  }

  private void start(Term begun, Supplier<FloorFleet> starter) {
    try {
      FloorFleet started = starter.get();
      agents = started;
      startFailure = null;
      awaitsStore = false;
      begun.asked.complete(started);
    } catch (RuntimeException e) {
      awaitsStore = isOfStore(e);
      startFailure = Phrase.FLOOR_CANNOT_START.with(name(), String.valueOf(e.getMessage()));
      begun.asked.completeExceptionally(e);
      throw e;
    }
  }

  private static boolean isOfStore(Throwable failure) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      if (cause instanceof StoreException) {
        return true;
      }
    }
    return false;
  }

  /**
   * Starts agents where none could be started before.
   *
   * @throws IllegalStateException they cannot start; whoever asks them is told so
   */
  void startAgain(Function<FloorMap, FloorFleet> starter) {
    Term begun = new Term();
    var _ = beginEnding(begun);
    start(begun, () -> starter.apply(map));
  }

  /**
   * Decides, while nothing is asked of its agents, whether another map comes in force; then others
   * begin on it.
   *
   * @param decision the map that is in force from now on; empty: it stays as it is
   * @param starter of agents on a map
   * @throws IllegalStateException they cannot start; whoever asks them is told so
   */
  void change(Supplier<Optional<FloorMap>> decision, Function<FloorMap, FloorFleet> starter) {
    Term begun = new Term();
    Term ending = beginEnding(begun);
    Optional<FloorMap> next = Optional.empty();
    try {
      next = decision.get();
    } finally {
      if (next.isEmpty()) {
        goOn(begun, ending);
      }
    }
    next.ifPresent(
        decided -> {
          endAgents();
          map = decided;
          start(begun, () -> starter.apply(decided));
        });
  }

  /** The same agents are asked in the next term as before. */
  private void goOn(Term next, Term before) {
    FloorFleet running = agents;
    if (running == null) {
      next.asked.completeExceptionally(before.asked.exceptionNow());
    } else {
      next.asked.complete(running);
    }
  }

  /**
   * Decides, while nothing is asked of its agents, whether it is removed.
   *
   * @return whether it was
   */
  boolean remove(BooleanSupplier decision) {
    return end(decision, new RemovedException());
  }

  private boolean end(BooleanSupplier decision, RuntimeException toldLater) {
    Term gone = new Term();
    Term ending = beginEnding(gone);
    boolean ends = false;
    try {
      ends = decision.getAsBoolean();
    } finally {
      if (!ends) {
        goOn(gone, ending);
      }
    }
    if (ends) {
      gone.asked.completeExceptionally(toldLater);
      endAgents();
    }
    return ends;
  }

  /** Ends its agents for good, once what was asked is answered. */
  void close() {
    var _ = end(() -> true, new IllegalStateException("The floor is closed."));
  }

  /** From now on the other term is asked; waits until all that was asked before is answered. */
  private Term beginEnding(Term next) {
    Term ending;
    synchronized (this) {
      ending = term;
      term = next;
      ending.isEnding = true;
      completeIfDrained(ending);
    }
    try {
      ending.drained.get(DRAIN_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (ExecutionException | TimeoutException e) {
      log.warn("{}: calls were not answered in time.", name(), e);
    }
    return ending;
  }

  private void endAgents() {
    FloorFleet ended = agents;
    if (ended != null) {
      ended.close();
      agents = null;
    }
  }

  /** Who asks after it is gone. */
  private static final class RemovedException extends RuntimeException {
    private static final long serialVersionUID = 1;
  }
}
