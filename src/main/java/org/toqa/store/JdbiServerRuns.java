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
          endManualDrives(h, at);
          add(h, at, EventKind.FLEET_SERVER_STARTED, Phrase.SERVER_STARTED);
          h.execute("delete from server_runs");
          return h.execute("insert into server_runs (id, began_at) values (1, ?)", at);
        });
  }

  /** Nobody drives by hand what was driven when the server ended: no lease outlives it. */
  private static void endManualDrives(Handle h, Instant at) {
    List<EventRecord> ends =
        h.createQuery(
                """
                select b.robot, b.who from events b
                where b.kind = :began and b.id = (
                  select max(l.id) from events l
                  where l.robot = b.robot and l.kind in (:began, :ended))
                order by b.robot
                """)
            .bind("began", EventKind.ROBOT_MANUAL_BEGAN.text())
            .bind("ended", EventKind.ROBOT_MANUAL_ENDED.text())
            .map((row, _) -> endOfManualDrive(at, row.getString("robot"), row.getString("who")))
            .list();
    EventTable.addAll(h, ends);
  }

  private static EventRecord endOfManualDrive(Instant at, String robot, String who) {
    return new EventRecord(
        at,
        EventKind.ROBOT_MANUAL_ENDED,
        null,
        robot,
        EventRecord.SYSTEM,
        Phrase.MANUAL_DRIVE_BROKEN_OFF.with(who, robot, Phrase.SERVER_ENDED_MEANWHILE.with()));
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
