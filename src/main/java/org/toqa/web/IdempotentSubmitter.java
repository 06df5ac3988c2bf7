package org.toqa.web;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.OrderArchive;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.PartsToRetry;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;
import org.toqa.persistence.StoreException;

/**
 * Submits tasks to the fleet, each of them once: an order that comes again with its key gets the
 * task that it got before, also after a crash of the server. One server writes to a database, so
 * two orders with the same key that come at once are kept apart by a lock here.
 */
public final class IdempotentSubmitter {
  private static final int STRIPES = 64;

  private final Fleet fleet;
  private final TaskArchive archive;
  private final OrderArchive orders;
  private final Lock[] locks =
      Stream.generate(ReentrantLock::new).limit(STRIPES).toArray(Lock[]::new);

  public IdempotentSubmitter(Fleet fleet, TaskArchive archive, OrderArchive orders) {
    this.fleet = fleet;
    this.archive = archive;
    this.orders = orders;
  }

  /** The key of a user's order, which nobody else's is. */
  public static UUID idempotencyKey(Account user, String given) {
    return UUID.nameUUIDFromBytes((user.id() + " " + given).getBytes(StandardCharsets.UTF_8));
  }

  /** As whom a user of the web application orders. */
  public static Orderer orderer(Account user) {
    return new Orderer(user.name(), user.id());
  }

  public KeyedAnswer<TaskView> submit(TaskOrder order, Account user, UUID key) {
    Lock lock = lockOf(key);
    lock.lock();
    try {
      requireDecided(List.of(key));
      Optional<TaskView> before = archive.taskByKey(key);
      if (before.isEmpty()) {
        return new KeyedAnswer.Answered<>(
            FleetAnswers.await(fleet.submit(order, orderer(user), key)));
      }
      return order.isOrderOf(before.get().task())
          ? new KeyedAnswer.Repeated<>(before.get())
          : new KeyedAnswer.KeyReused<>();
    } finally {
      lock.unlock();
    }
  }

  /** What became of orders of which all are wanted or none. */
  public sealed interface BatchOutcome {
    record Answered(BatchAnswer answer) implements BatchOutcome {}

    /** They came before, and these are their tasks. */
    record Repeated(List<TaskView> tasks) implements BatchOutcome {}

    /** Their key came before with other orders. */
    record KeyReused() implements BatchOutcome {}
  }

  /**
   * All orders of a table, or none; one of a single piece is an ordinary task.
   *
   * @param rows at least one
   */
  public BatchOutcome submitTable(List<PartsOrder> rows, Account user, UUID key) {
    List<TaskOrder> orders = rows.stream().flatMap(row -> row.tasks().stream()).toList();
    List<@Nullable OrderPart> parts = new ArrayList<>();
    for (PartsOrder row : rows) {
      parts.addAll(
          row.tasks().size() == 1 ? Collections.singletonList(null) : List.copyOf(row.parts()));
    }
    return submitAll(orders, parts, user, key, before -> isTable(rows, before));
  }

  private static boolean isTable(List<PartsOrder> rows, List<TransportTask> tasks) {
    int next = 0;
    for (PartsOrder row : rows) {
      int end = next + row.tasks().size();
      if (end > tasks.size()) {
        return false;
      }
      List<TransportTask> ofRow = tasks.subList(next, end);
      boolean isSame =
          ofRow.size() == 1
              ? ofRow.getFirst().part() == null
                  && row.tasks().getFirst().isOrderOf(ofRow.getFirst())
              : row.isOrderOf(ofRow);
      if (!isSame) {
        return false;
      }
      next = end;
    }
    return next == tasks.size();
  }

  /** All parts of an order, or none. */
  public BatchOutcome submitOrder(PartsOrder order, Account user, UUID key) {
    return submitAll(
        order.tasks(),
        List.<@Nullable OrderPart>copyOf(order.parts()),
        user,
        key,
        order::isOrderOf);
  }

  /**
   * @param orders at least one; the key after the last one's shows whether there were more before
   * @param parts which part of an order each is; null: it is ordered by itself
   * @param isSame whether the tasks that came with the key before are those that are ordered now
   */
  private BatchOutcome submitAll(
      List<TaskOrder> orders,
      List<@Nullable OrderPart> parts,
      Account user,
      UUID key,
      Predicate<List<TransportTask>> isSame) {
    List<UUID> keys =
        IntStream.rangeClosed(0, orders.size())
            .mapToObj(place -> idempotencyKey(key, place))
            .toList();
    Lock lock = lockOf(key);
    lock.lock();
    try {
      requireDecided(keys);
      if (archive.taskByKey(keys.getFirst()).isEmpty()) {
        return new BatchOutcome.Answered(
            FleetAnswers.await(
                fleet.submitAll(orders, parts, orderer(user), keys.subList(0, orders.size()))));
      }
      List<TaskView> before = keys.stream().flatMap(k -> archive.taskByKey(k).stream()).toList();
      return isSame.test(before.stream().map(TaskView::task).toList())
          ? new BatchOutcome.Repeated(before)
          : new BatchOutcome.KeyReused();
    } finally {
      lock.unlock();
    }
  }

  /**
   * Orders again what of an order has ended without delivery. Whoever wants it at the same time
   * finds it done.
   *
   * @return empty: there is no such order, or nothing of it is to be ordered again
   */
  public Optional<BatchAnswer> retry(long order, Account user) {
    Lock lock = lockOf(new UUID(0, order));
    lock.lock();
    try {
      return orders
          .order(order)
          .map(PartsToRetry::of)
          .filter(again -> !again.orders().isEmpty())
          .map(
              again ->
                  FleetAnswers.await(
                      fleet.submitAll(
                          again.orders(),
                          again.parts(),
                          orderer(user),
                          again.orders().stream().map(_ -> UUID.randomUUID()).toList())));
    } finally {
      lock.unlock();
    }
  }

  private Lock lockOf(UUID key) {
    return locks[Math.floorMod(key.hashCode(), STRIPES)];
  }

  /**
   * @throws StoreException while it is not known what becomes of an earlier order with such a key;
   *     under the key's lock no other one begins meanwhile
   */
  private void requireDecided(List<UUID> keys) {
    if (keys.stream().anyMatch(fleet::isSubmissionPending)) {
      throw new StoreException("What was ordered with this key before is being withdrawn.", null);
    }
  }

  private static UUID idempotencyKey(UUID batchKey, int index) {
    return UUID.nameUUIDFromBytes((batchKey + " " + index).getBytes(StandardCharsets.UTF_8));
  }
}
