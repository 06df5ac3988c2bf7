package org.toqa.store;

import java.time.Instant;
import java.util.List;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.wording.Phrase;

/** Tells in the history, at a server's start, that the one before was not stopped but ended. */
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
            EventTable.addAll(
                h,
                List.of(
                    new EventRecord(
                        at,
                        EventKind.FLEET_SERVER_ENDED,
                        null,
                        null,
                        EventRecord.SYSTEM,
                        Phrase.SERVER_HAD_ENDED.with())));
          }
          h.execute("delete from server_runs");
          return h.execute("insert into server_runs (id, began_at) values (1, ?)", at);
        });
  }

  /** The server is being stopped. */
  public void end(Instant at) {
    sql.inTransaction(h -> h.execute("update server_runs set ended_at = ?", at));
  }
}
