package org.toqa.fleet;

import java.util.List;
import java.util.stream.IntStream;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;

/**
 * What is ordered to be carried as several tasks.
 *
 * @param tasks of its parts, from the first to the last; at least one
 */
public record PartsOrder(String name, OrderPart.Kind kind, List<TaskOrder> tasks) {
  /** Pieces of an order. */
  public static final int MAX_PIECES = 100;

  /** Stops of an order, with its start. */
  public static final int MAX_STOPS = 20;

  public PartsOrder {
    tasks = List.copyOf(tasks);
  }

  /** One task. */
  public static PartsOrder of(TaskOrder task) {
    return new PartsOrder(task.name(), OrderPart.Kind.PIECES, List.of(task));
  }

  /** Which part each of its tasks is. */
  public List<OrderPart> parts() {
    return IntStream.rangeClosed(1, tasks.size())
        .mapToObj(position -> OrderPart.ofNew(name, kind, position, tasks.size()))
        .toList();
  }

  /** Whether these tasks, in their order, are what this orders. */
  public boolean isOrderOf(List<TransportTask> stored) {
    return stored.size() == tasks.size()
        && IntStream.range(0, tasks.size()).allMatch(i -> isPart(stored.get(i), i));
  }

  private boolean isPart(TransportTask stored, int index) {
    OrderPart part = stored.part();
    return part != null
        && part.kind() == kind
        && part.count() == tasks.size()
        && part.position() == index + 1
        && tasks.get(index).isOrderOf(stored);
  }
}
