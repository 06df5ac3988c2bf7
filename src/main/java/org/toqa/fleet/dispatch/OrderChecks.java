package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.CheckRefusedException.Reason;
import org.toqa.fleet.FleetRuntime;
import org.toqa.planning.SearchLimit;
import org.toqa.traffic.Deadline;

/**
 * Lets what orders and previews need be computed on few threads, so that no user keeps the others
 * waiting.
 *
 * <ol>
 *   <li>A user has few checks open at once; a further one is refused.
 *   <li>A thread that comes free takes work of the user for whom the fewest work, in turn: another
 *       user's order waits for as many pieces of work as there are users, not for all their orders.
 *   <li>A check has a time limit. After it what waits is dropped and what is searched is ended, so
 *       a thread comes free within that limit whatever was ordered.
 * </ol>
 *
 * Any thread may call it.
 */
public final class OrderChecks {
  /** With what is stored afterwards shorter than any caller waits for the answer. */
  static final Duration LIMIT = Duration.ofSeconds(6);

  /** Of all checks of orders together, so that they leave processors to the fleet. */
  private static final int THREADS = Math.max(2, Runtime.getRuntime().availableProcessors() / 2);

  /** Whose work the fleet's own is; no user has that name. */
  private static final String FLEET = "";

  private final Executor executor;
  private final int perUser;
  private final LongSupplier nanoTime;

  /** By user, those that have waited for a turn longest first. Guarded by this. */
  private final Map<String, Lane> lanes = new LinkedHashMap<>();

  private static final class Lane {
    private final Deque<Runnable> waiting = new ArrayDeque<>();
    private int open;
    private int running;
  }

  /**
   * Those of a fleet.
   *
   * @param perUser how many checks of one user are open at once
   */
  public static OrderChecks of(FleetRuntime runtime, int perUser) {
    return new OrderChecks(runtime.boundedExecutor("path", THREADS), perUser, runtime::nanoTime);
  }

  /**
   * @param executor does what it is given beside each other, as much as there is to be at once
   * @param perUser how many checks of one user are open at once
   * @param nanoTime nanoseconds from any fixed moment
   */
  OrderChecks(Executor executor, int perUser, LongSupplier nanoTime) {
    this.executor = executor;
    this.perUser = perUser;
    this.nanoTime = nanoTime;
  }

  /**
   * Begins one of that user's checks; he has one fewer until it is closed.
   *
   * @throws CheckRefusedException he has as many as he may
   */
  synchronized Check begin(String user) {
    Lane lane = lanes.computeIfAbsent(user, _ -> new Lane());
    if (lane.open >= perUser) {
      throw new CheckRefusedException(Reason.TOO_MANY);
    }
    lane.open++;
    return new Check(user, Deadline.in(LIMIT, nanoTime));
  }

  /** For what the fleet wants to know itself: it has its turn as a user has, and no limit. */
  Executor fleetExecutor() {
    return work -> add(FLEET, work);
  }

  private void add(String user, Runnable work) {
    synchronized (this) {
      lanes.computeIfAbsent(user, _ -> new Lane()).waiting.add(work);
    }
    executor.execute(this::runNext);
  }

  /** It is called as often as there is work, and does what is due then. */
  private void runNext() {
    String user;
    Lane lane;
    Runnable work;
    synchronized (this) {
      user =
          lanes.entrySet().stream()
              .filter(entry -> !entry.getValue().waiting.isEmpty())
              .min(Comparator.comparingInt(entry -> entry.getValue().running))
              .orElseThrow()
              .getKey();
      lane = lanes.remove(user);
      lanes.put(user, lane); // at the end
      work = lane.waiting.remove();
      lane.running++;
    }
    try {
      work.run();
    } finally {
      synchronized (this) {
        lane.running--;
        removeIfUnused(user, lane);
      }
    }
  }

  private void removeIfUnused(String user, Lane lane) {
    if (lane.open == 0 && lane.running == 0 && lane.waiting.isEmpty()) {
      lanes.remove(user, lane);
    }
  }

  private synchronized void end(String user) {
    Lane lane = lanes.get(user);
    if (lane != null) {
      lane.open--;
      removeIfUnused(user, lane);
    }
  }

  /** One order, preview or table of orders while it is checked. */
  final class Check implements AutoCloseable {
    private final String user;
    private final Deadline deadline;
    private final AtomicBoolean isOpen = new AtomicBoolean(true);

    private Check(String user, Deadline deadline) {
      this.user = user;
      this.deadline = deadline;
    }

    /**
     * Does work for it in its user's turn. Where its time is over, the result is a {@link
     * CheckRefusedException}.
     *
     * @param work its searches ask {@link SearchLimit}
     */
    <T> CompletableFuture<T> run(Supplier<T> work) {
      CompletableFuture<T> result = new CompletableFuture<>();
      add(user, () -> complete(result, work));
      return result;
    }

    private <T> void complete(CompletableFuture<T> result, Supplier<T> work) {
      try {
        if (deadline.isPassed()) {
          result.completeExceptionally(new CheckRefusedException(Reason.OUT_OF_TIME));
        } else {
          result.complete(SearchLimit.within(deadline::isPassed, work));
        }
      } catch (SearchLimit.SearchTimeoutException e) {
        result.completeExceptionally(new CheckRefusedException(Reason.OUT_OF_TIME));
      } catch (RuntimeException | Error e) {
        result.completeExceptionally(e);
      }
    }

    /** From now on its user may have another one; what it still does is done. */
    @Override
    public void close() {
      if (isOpen.getAndSet(false)) {
        end(user);
      }
    }
  }
}
