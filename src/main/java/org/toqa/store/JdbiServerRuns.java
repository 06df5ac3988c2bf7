package org.toqa.store;

import java.time.Instant;
import java.util.List;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.wording.Phrase;

/**
 * Tells in the history when the server was started and stopped, and, at a start, that the one
 * before had ended without being stopped.
 */
public final class JdbiServerRuns {
  private final SqlExecutor sql;

  public JdbiServerRuns(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  /** The server has started. */
  public void begin(Instant at) {
    sql.inTransaction(
        h -> {
          boolean wasKilled =
              h.createQuery("select count(*) from server_runs where ended_at is null")
                      .mapTo(Integer.class)
                      .one()
                  > 0;
          if (wasKilled) {
            add(h, at, EventKind.FLEET_SERVER_ENDED, Phrase.SERVER_HAD_ENDED);
          }
          add(h, at, EventKind.FLEET_SERVER_STARTED, Phrase.SERVER_STARTED);
          h.execute("delete from server_runs");
          return h.execute("insert into server_runs (id, began_at) values (1, ?)", at);
        });
  }

  /** The server is being stopped. */
  public void end(Instant at) {
    sql.inTransaction(
        h -> {
          add(h, at, EventKind.FLEET_SERVER_STOPPED, Phrase.SERVER_STOPPED);
          return h.execute("update server_runs set ended_at = ?", at);
        });
  }

  private static void add(Handle h, Instant at, EventKind kind, Phrase phrase) {
    EventTable.addAll(
        h, List.of(new EventRecord(at, kind, null, null, EventRecord.SYSTEM, phrase.with())));
  }
}
