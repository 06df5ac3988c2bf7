package org.toqa.store;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.IntSupplier;
import org.jdbi.v3.core.Jdbi;
import org.toqa.persistence.StoreException;

/** Removes what is too old to keep, a little at a time, so that nobody waits for it. */
public final class HistoryPruner {
  private static final int BATCH_SIZE = 1000;

  /** An event of a task stays as long as its task, where nobody has deleted that. */
  private static final String OLD_EVENTS =
      """
      delete from events where at < :before and (task_id is null
        or not exists (select 1 from tasks where tasks.id = events.task_id)) limit
      """
          + BATCH_SIZE;

  private static final String OLD_NOTICES =
      "delete from notices where ended_at < :before limit " + BATCH_SIZE;

  private static final String OLD_UTILISATION =
      "delete from robot_use where at < :before limit " + BATCH_SIZE;

  private static final String OLD_SESSIONS =
      "delete from sessions where expires_at < :before limit " + BATCH_SIZE;

  private static final String OLD_LINKS =
      "delete from reset_links where expires_at < :before limit " + BATCH_SIZE;

  private static final String OLD_MAPS =
      """
      select m.id from floor_maps m where m.since < :before
        and (exists (select 1 from floor_maps n where n.floor = m.floor and n.id > m.id
            and n.since < :before)
          or not exists (select 1 from floors f where f.name = m.floor))
      order by m.id limit
      """
          + BATCH_SIZE;

  private static final String OLD_TASKS =
      """
      select id from tasks where changed_at < :before
        and (state = 'DONE' or state in ('FAILED', 'CANCELLED') and set_down_x is null)
        and not exists (select 1 from tasks o where o.order_id = tasks.order_id
          and o.state not in ('DONE', 'FAILED', 'CANCELLED'))
      order by changed_at limit
      """
          + BATCH_SIZE;

  private static final String EMPTY_ORDERS =
      "delete from orders where not exists (select 1 from tasks where tasks.order_id = orders.id)";

  private final SqlExecutor sql;

  public HistoryPruner(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  /**
   * How many points were removed that are older than this; batteries' levels, and loads' places and
   * planned paths that had ended before, go too.
   *
   * @throws StoreException when the database does not answer
   */
  public long pruneTracks(Instant before) {
    deleteInBatches(() -> deleteOlderRows("battery_levels", "at", before));
    deleteInBatches(() -> deleteOlderRows("load_places", "until", before));
    deleteInBatches(() -> deleteOlderRows("planned_paths", "until", before));
    return deleteInBatches(() -> deleteOlderRows("tracks", "at", before));
  }

  private int deleteOlderRows(String table, String column, Instant before) {
    return sql.withHandle(
        h ->
            h.createUpdate(
                    "delete from " + table + " where " + column + " < :before limit " + BATCH_SIZE)
                .bind("before", before.toEpochMilli())
                .execute());
  }

  /**
   * How many tasks were removed, with their events, that ended before this; other events, ended
   * notices and what robots did go too, where they are older. Those of an order go when all of it
   * has ended, and none whose load was left on the floor.
   *
   * @throws StoreException when the database does not answer
   */
  public long pruneHistory(Instant before) {
    deleteInBatches(() -> deleteOlder(OLD_EVENTS, before));
    deleteInBatches(() -> deleteOlder(OLD_NOTICES, before));
    deleteInBatches(() -> deleteOlder(OLD_UTILISATION, before));
    deleteInBatches(() -> deleteOldMaps(before));
    return deleteInBatches(() -> deleteEndedTasks(before));
  }

  /**
   * Logins, tokens and links that expired before this are removed.
   *
   * @throws StoreException when the database does not answer
   */
  public void pruneExpired(Instant before) {
    deleteInBatches(() -> deleteOlder(OLD_SESSIONS, before));
    deleteInBatches(() -> deleteOlder(OLD_LINKS, before));
  }

  /**
   * When the newest event was; empty: there is none.
   *
   * @throws StoreException when the database does not answer
   */
  public Optional<Instant> newestEvent() {
    return sql.withHandle(
        h -> h.createQuery("select max(at) from events").mapTo(Instant.class).findOne());
  }

  private static long deleteInBatches(IntSupplier removeSome) {
    long removed = 0;
    int now;
    do {
      now = removeSome.getAsInt();
      removed += now;
    } while (now == BATCH_SIZE);
    return removed;
  }

  /** Of each floor that there is, the map in force then stays. */
  private int deleteOldMaps(Instant before) {
    return sql.inTransaction(
        h -> {
          List<Long> ids = h.createQuery(OLD_MAPS).bind("before", before).mapTo(Long.class).list();
          if (!ids.isEmpty()) {
            h.createUpdate("delete from floor_maps where id in (<ids>)")
                .bindList("ids", ids)
                .execute();
          }
          return ids.size();
        });
  }

  private int deleteOlder(String statement, Instant before) {
    return sql.withHandle(h -> h.createUpdate(statement).bind("before", before).execute());
  }

  private int deleteEndedTasks(Instant before) {
    return sql.inTransaction(
        h -> {
          List<Long> ids = h.createQuery(OLD_TASKS).bind("before", before).mapTo(Long.class).list();
          if (!ids.isEmpty()) {
            h.createUpdate("delete from events where task_id in (<ids>)")
                .bindList("ids", ids)
                .execute();
            h.createUpdate("delete from tasks where id in (<ids>)").bindList("ids", ids).execute();
            h.execute(EMPTY_ORDERS);
          }
          return ids.size();
        });
  }
}
