package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.supervision.SupervisedBox;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionStore;
import tools.jackson.databind.json.JsonMapper;

/** Supervisors and their boxes on H2 and on MySQL. */
public final class JdbiSupervisionStore implements SupervisionStore {
  /** No robot's name has it. */
  private static final String BETWEEN = ",";

  private final SqlExecutor sql;

  public JdbiSupervisionStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public List<Supervision> supervisions() {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select floor, run_key, supervisor, workers, overlaps, user_name, state,
                      begun_at, ended_at, idle_seconds, boxes, seen
                    from supervisions
                    """)
                .map((row, _) -> JdbiSupervisionStore.supervision(row))
                .list());
  }

  private static Supervision supervision(ResultSet row) throws SQLException {
    Map<Integer, SupervisedBox> boxes = new TreeMap<>();
    for (SupervisedBox box :
        JsonMapper.shared().readValue(row.getString("boxes"), SupervisedBox[].class)) {
      boxes.put(box.number(), box);
    }
    return new Supervision(
        row.getString("floor"),
        row.getString("run_key"),
        row.getString("supervisor"),
        Arrays.asList(row.getString("workers").split(BETWEEN, -1)),
        row.getBoolean("overlaps"),
        row.getString("user_name"),
        Supervision.State.valueOf(row.getString("state")),
        DatabaseTypes.instant(row, "begun_at"),
        row.getObject("ended_at") == null ? null : DatabaseTypes.instant(row, "ended_at"),
        row.getDouble("idle_seconds"),
        boxes,
        row.getString("seen"));
  }

  @Override
  public void remove(String floor) {
    sql.inTransaction(h -> h.execute("delete from supervisions where floor = ?", floor));
  }

  @Override
  public void save(Supervision supervision, List<EventRecord> events) {
    sql.inTransaction(
        h -> {
          h.createUpdate("delete from supervisions where floor = :floor")
              .bind("floor", supervision.floor())
              .execute();
          h.createUpdate(
                  """
                  insert into supervisions (floor, run_key, supervisor, workers, overlaps,
                    user_name, state, begun_at, ended_at, idle_seconds, boxes, seen)
                  values (:floor, :run, :supervisor, :workers, :overlaps, :user, :state, :begun,
                    :ended, :idle, :boxes, :seen)
                  """)
              .bind("floor", supervision.floor())
              .bind("run", supervision.run())
              .bind("supervisor", supervision.supervisor())
              .bind("workers", String.join(BETWEEN, supervision.workers()))
              .bind("overlaps", supervision.overlaps())
              .bind("user", supervision.user())
              .bind("state", supervision.state().name())
              .bind("begun", supervision.begunAt())
              .bind("ended", supervision.endedAt())
              .bind("idle", supervision.idleSeconds())
              .bind("boxes", JsonMapper.shared().writeValueAsString(supervision.boxes().values()))
              .bind("seen", supervision.seen())
              .execute();
          EventTable.addAll(h, events);
          return null;
        });
  }
}
