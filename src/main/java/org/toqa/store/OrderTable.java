package org.toqa.store;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TransportTask;

/** The table of orders, within a transaction of somebody else. */
final class OrderTable {
  private OrderTable() {}

  /**
   * Adds the orders that are new with their tasks.
   *
   * @param submissions the parts of a new order follow each other, its first one first
   * @return the same, with the ids of the orders
   */
  static List<Submission> addNew(Handle h, List<Submission> submissions) {
    List<Submission> known = new ArrayList<>();
    long newest = 0;
    for (Submission submission : submissions) {
      TransportTask task = submission.task();
      OrderPart part = task.part();
      if (part == null || part.order() != 0) {
        known.add(submission);
        continue;
      }
      if (part.position() == 1) {
        newest = add(h, task, part);
      }
      known.add(new Submission(task.withPart(part.withOrder(newest)), submission.idempotencyKey()));
    }
    return known;
  }

  private static long add(Handle h, TransportTask first, OrderPart part) {
    return h.createUpdate(
            """
            insert into orders (name, kind, parts, created_at) values (:name, :kind, :parts, :at)
            """)
        .bind("name", part.name())
        .bind("kind", part.kind())
        .bind("parts", part.count())
        .bind("at", first.createdAt())
        .executeAndReturnGeneratedKeys("id")
        .mapTo(Long.class)
        .one();
  }

  /**
   * The order that the task belongs to, if it does to one.
   *
   * @param column by whose value the task is found
   */
  static Optional<Long> orderOf(Handle h, String column, Object value) {
    return h.createQuery(
            "select order_id from tasks where order_id is not null and " + column + " = :value")
        .bind("value", value)
        .mapTo(Long.class)
        .findOne();
  }

  static void deleteIfEmpty(Handle h, long order) {
    h.createUpdate(
            """
            delete from orders where id = :id
              and not exists (select 1 from tasks where tasks.order_id = orders.id)
            """)
        .bind("id", order)
        .execute();
  }
}
