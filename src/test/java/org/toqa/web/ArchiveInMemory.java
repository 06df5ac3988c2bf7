package org.toqa.web;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Stream;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.OrderArchive;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskArchive;
import org.toqa.fleet.TaskTraces;
import org.toqa.fleet.TaskView;
import org.toqa.mission.OrderPart;
import org.toqa.persistence.StoreException;

/** Tasks that were accepted, in memory: it finds them by state and text, and knows who follows. */
public abstract class ArchiveInMemory extends SnapshotsInMemory
    implements TaskArchive, OrderArchive, TaskTraces {
  final Map<UUID, Long> keys = new HashMap<>();
  final List<EventRecord> events = new ArrayList<>();
  private final Set<List<Long>> traces = new HashSet<>();
  private volatile boolean isUnreadable;
  long nextId = 1;

  void forgetTasks() {
    isUnreadable = false;
    tasks.clear();
    keys.clear();
    events.clear();
    traces.clear();
    nextId = 1;
  }

  @Override
  public void setFollowed(long user, long task, boolean followed) {
    lock.lock();
    try {
      if (followed) {
        traces.add(List.of(user, task));
      } else {
        traces.remove(List.of(user, task));
      }
    } finally {
      lock.unlock();
    }
  }

  @Override
  public boolean isFollowed(long user, long task) {
    lock.lock();
    try {
      return traces.contains(List.of(user, task));
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<TaskView> tasks(Filter filter, Sort sort, int offset, int limit) {
    lock.lock();
    try {
      Comparator<TaskView> order =
          sort.by() == Sort.Column.LOAD
              ? Comparator.comparingDouble(t -> t.task().load())
              : Comparator.comparingLong(TaskView::id);
      return tasks.stream()
          .filter(task -> isIncluded(task, filter))
          .sorted(sort.descending() ? order.reversed() : order)
          .skip(offset)
          .limit(limit)
          .toList();
    } finally {
      lock.unlock();
    }
  }

  /** By state, text and follower only; the store's tests hold the rest. */
  private boolean isIncluded(TaskView task, Filter filter) {
    return (filter.states().isEmpty() || filter.states().contains(task.state()))
        && (filter.text() == null || task.task().name().contains(filter.text()))
        && (filter.follower() == null || isFollowed(filter.follower(), task.id()));
  }

  @Override
  public Optional<TaskView> taskByKey(UUID key) {
    lock.lock();
    try {
      return Optional.ofNullable(keys.get(key)).flatMap(this::task);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public Optional<TaskView> task(long id) {
    lock.lock();
    try {
      return tasks.stream().filter(t -> t.id() == id).findFirst();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public Optional<OrderView> order(long id) {
    return orders(List.of(id)).stream().findFirst();
  }

  @Override
  public List<OrderView> orders(int offset, int limit) {
    return orders(orderIds()).stream().skip(offset).limit(limit).toList();
  }

  @Override
  public long orderCount() {
    return orderIds().size();
  }

  /** Whether orders can be read. */
  public void setOrdersReadable(boolean readable) {
    isUnreadable = !readable;
  }

  @Override
  public List<OrderView> orders(Collection<Long> ids) {
    if (isUnreadable) {
      throw new StoreException("The database does not answer.", null);
    }
    lock.lock();
    try {
      return ids.stream()
          .distinct()
          .sorted(Comparator.reverseOrder())
          .flatMap(id -> orderOf(tasks.stream().filter(task -> isPartOf(task, id)).toList()))
          .toList();
    } finally {
      lock.unlock();
    }
  }

  private List<Long> orderIds() {
    lock.lock();
    try {
      return tasks.stream()
          .flatMap(task -> Stream.ofNullable(task.task().part()))
          .map(OrderPart::order)
          .distinct()
          .toList();
    } finally {
      lock.unlock();
    }
  }

  private static boolean isPartOf(TaskView task, long order) {
    OrderPart part = task.task().part();
    return part != null && part.order() == order;
  }

  private static Stream<OrderView> orderOf(List<TaskView> tasks) {
    return tasks.stream()
        .limit(1)
        .flatMap(
            first ->
                Stream.ofNullable(first.task().part())
                    .map(
                        part ->
                            new OrderView(
                                part.order(),
                                part.name(),
                                part.kind(),
                                part.count(),
                                first.task().createdAt(),
                                tasks)));
  }

  @Override
  public List<EventRecord> history(long id) {
    lock.lock();
    try {
      return events.stream().filter(e -> e.task() != null && e.task() == id).toList();
    } finally {
      lock.unlock();
    }
  }

  @Override
  public long count(Filter filter) {
    lock.lock();
    try {
      return tasks.stream().filter(task -> isIncluded(task, filter)).count();
    } finally {
      lock.unlock();
    }
  }
}
