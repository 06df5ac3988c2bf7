package org.toqa.store;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.OrderArchive;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.mission.OrderPart;

/** Orders and their tasks, on H2 and on MySQL. */
public final class JdbiOrderArchive implements OrderArchive {
  private static final String ORDERS = "select id, name, kind, parts, created_at from orders ";

  private final SqlExecutor sql;

  public JdbiOrderArchive(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  /** A row of the table of orders. */
  record OrderRow(long id, String name, OrderPart.Kind kind, int parts, Instant createdAt) {}

  @Override
  public Optional<OrderView> order(long id) {
    return orders(List.of(id)).stream().findFirst();
  }

  @Override
  public List<OrderView> orders(Collection<Long> ids) {
    if (ids.isEmpty()) {
      return List.of();
    }
    return sql.withHandle(
        h ->
            withTasks(
                h,
                h.createQuery(ORDERS + "where id in (<ids>) order by id desc")
                    .bindList("ids", List.copyOf(ids))
                    .mapTo(OrderRow.class)
                    .list()));
  }

  @Override
  public List<OrderView> orders(int offset, int limit) {
    return sql.withHandle(
        h ->
            withTasks(
                h,
                h.createQuery(ORDERS + "order by id desc limit :limit offset :offset")
                    .bind("limit", limit)
                    .bind("offset", offset)
                    .mapTo(OrderRow.class)
                    .list()));
  }

  @Override
  public long orderCount() {
    return sql.withHandle(
        h -> h.createQuery("select count(*) from orders").mapTo(Long.class).one());
  }

  private static List<OrderView> withTasks(Handle h, List<OrderRow> orders) {
    if (orders.isEmpty()) {
      return List.of();
    }
    List<TaskRow> rows =
        h.createQuery(
                "select "
                    + TaskRow.COLUMNS
                    + " from tasks where order_id in (<orders>) order by order_part, id")
            .bindList("orders", orders.stream().map(OrderRow::id).toList())
            .mapTo(TaskRow.class)
            .list();
    Map<Long, List<TaskView>> tasks = new HashMap<>();
    for (TaskView task : TaskTable.withRobots(h, rows, TaskRow::toView)) {
      OrderPart part = task.task().part();
      if (part != null) {
        tasks.computeIfAbsent(part.order(), _ -> new ArrayList<>()).add(task);
      }
    }
    return orders.stream()
        .map(
            order ->
                new OrderView(
                    order.id(),
                    order.name(),
                    order.kind(),
                    order.parts(),
                    order.createdAt(),
                    tasks.getOrDefault(order.id(), List.of())))
        .toList();
  }
}
