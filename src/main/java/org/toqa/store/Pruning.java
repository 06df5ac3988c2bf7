package org.toqa.store;

import java.time.Instant;
import java.util.List;
import java.util.function.IntSupplier;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.FleetStore.StoreException;

/** Removes what is too old to keep, a little at a time, so that nobody waits for it. */
public final class Pruning {
  private static final int AT_ONCE = 1000;

  /** An event of a task stays as long as its task. */
  private static final String OLD_EVENTS =
      "delete from events where at < :before and task_id is null limit " + AT_ONCE;

  private static final String OLD_USE = "delete from robot_use where at < :before limit " + AT_ONCE;

  private static final String OLD_TASKS =
      """
      select id from tasks where changed_at < :before and state in ('DONE', 'FAILED', 'CANCELLED')
      order by changed_at limit
      """
          + AT_ONCE;

  private final Sql sql;

  public Pruning(Jdbi jdbi) {
    this.sql = new Sql(jdbi);
  }

  /**
   * How many points were removed that are older than this.
   *
   * @throws StoreException when the database does not answer
   */
  public long tracks(Instant before) {
    return all(
        () ->
            sql.in(
                h ->
                    h.createUpdate("delete from tracks where at < :before limit " + AT_ONCE)
                        .bind("before", before.toEpochMilli())
                        .execute()));
  }

  /**
   * How many tasks were removed, with their events, that ended before this; other events and what
   * robots did go too, where they are older.
   *
   * @throws StoreException when the database does not answer
   */
  public long history(Instant before) {
    all(() -> older(OLD_EVENTS, before));
    all(() -> older(OLD_USE, before));
    return all(() -> endedTasks(before));
  }

  private static long all(IntSupplier removeSome) {
    long removed = 0;
    int now;
    do {
      now = removeSome.getAsInt();
      removed += now;
    } while (now == AT_ONCE);
    return removed;
  }

  private int older(String statement, Instant before) {
    return sql.in(h -> h.createUpdate(statement).bind("before", Sql.utc(before)).execute());
  }

  private int endedTasks(Instant before) {
    return sql.inTransaction(
        h -> {
          List<Long> ids =
              h.createQuery(OLD_TASKS).bind("before", Sql.utc(before)).mapTo(Long.class).list();
          if (!ids.isEmpty()) {
            h.createUpdate("delete from events where task_id in (<ids>)")
                .bindList("ids", ids)
                .execute();
            h.createUpdate("delete from tasks where id in (<ids>)").bindList("ids", ids).execute();
          }
          return ids.size();
        });
  }
}
