package org.toqa.store;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.wording.Sentence;

/** The table of events, within a transaction of somebody else. */
final class EventTable {
  static final String COLUMNS = "at, kind, task_id, robot, who, text, said, floor";

  private EventTable() {}

  /**
   * Adds what is not there yet: a change is tried again when nobody knows whether it was stored,
   * and must not be told twice.
   */
  static void addMissing(Handle h, List<EventRecord> events) {
    addAll(h, events.stream().filter(e -> !isStored(h, e)).toList());
  }

  /** Adds what cannot be there yet. */
  static void addAll(Handle h, List<EventRecord> events) {
    PreparedBatch batch =
        h.prepareBatch(
            "insert into events ("
                + COLUMNS
                + ") values (:at, :kind, :task, :robot, :who, :text, :said, coalesce(:floor,"
                + " (select floor from tasks where id = :task),"
                + " (select floor from robots where name = :robot)))");
    for (EventRecord e : events) {
      batch
          .bind("at", e.at())
          .bind("kind", e.kind())
          .bind("task", e.task())
          .bind("robot", e.robot())
          .bind("who", e.who())
          .bind("text", e.text())
          .bind("said", SentenceJson.write(e.sentence()))
          .bind("floor", e.floor())
          .add();
    }
    if (batch.size() > 0) {
      batch.execute();
    }
  }

  /** What somebody did with a user. */
  static void addAccountEvent(Handle h, Instant at, EventKind kind, String by, Sentence said) {
    addAll(h, List.of(new EventRecord(at, kind, null, null, by, said)));
  }

  private static boolean isStored(Handle h, EventRecord e) {
    return h
        .createQuery("select id, " + COLUMNS + " from events where at = :at and kind = :kind")
        .bind("at", e.at())
        .bind("kind", e.kind())
        .mapTo(EventRow.class)
        .map(EventRow::toRecord)
        .stream()
        .anyMatch(
            stored ->
                Objects.equals(stored.task(), e.task())
                    && Objects.equals(stored.robot(), e.robot())
                    && stored.who().equals(e.who())
                    && stored.text().equals(e.text()));
  }

  /** Oldest first. */
  static List<EventRecord> ofTask(Handle h, long task) {
    return h.createQuery("select id, " + COLUMNS + " from events where task_id = :task order by id")
        .bind("task", task)
        .mapTo(EventRow.class)
        .map(EventRow::toRecord)
        .list();
  }

  /** A row of the table. */
  record EventRow(
      long id,
      Instant at,
      String kind,
      @Nullable Long taskId,
      @Nullable String robot,
      String who,
      String text,
      @Nullable String said,
      @Nullable String floor) {
    EventRecord toRecord() {
      return new EventRecord(at, kind, taskId, robot, who, SentenceJson.read(said, text), floor);
    }
  }
}
