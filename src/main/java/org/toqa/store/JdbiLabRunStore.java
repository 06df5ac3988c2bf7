package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.jspecify.annotations.Nullable;
import org.toqa.lab.record.KeptDrawing;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabResult;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.LabRunState;
import org.toqa.lab.record.LabRunStore;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Runs of the laboratory on H2 and on MySQL. */
public final class JdbiLabRunStore implements LabRunStore {
  private static final String SELECT =
      """
      select id, experiment, seed, runs, parameters, user_name, ordered_at, started_at, ended_at,
        state, detail
      from lab_runs
      """;

  private static final int LONGEST_DETAIL = 1000;
  private static final int LONGEST_TITLE = 200;

  private final SqlExecutor sql;

  public JdbiLabRunStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public LabRun add(LabOrder order, String user, Instant at) {
    long id =
        sql.withHandle(
            h ->
                h.createUpdate(
                        """
                        insert into lab_runs
                          (experiment, seed, runs, parameters, user_name, ordered_at, state)
                        values (:experiment, :seed, :runs, :parameters, :user, :at, 'QUEUED')
                        """)
                    .bind("experiment", order.experiment())
                    .bind("seed", order.seed())
                    .bind("runs", order.runs())
                    .bind("parameters", JsonMapper.shared().writeValueAsString(order.values()))
                    .bind("user", user)
                    .bind("at", at)
                    .executeAndReturnGeneratedKeys("id")
                    .mapTo(Long.class)
                    .one());
    return new LabRun(id, order, user, at, null, null, LabRunState.QUEUED, null);
  }

  @Override
  public List<LabRun> runs() {
    return sql.withHandle(
        h ->
            h.createQuery(SELECT + "order by id desc")
                .map((row, _) -> JdbiLabRunStore.run(row))
                .list());
  }

  @Override
  public Optional<LabRun> run(long id) {
    return sql.withHandle(
        h ->
            h.createQuery(SELECT + "where id = :id")
                .bind("id", id)
                .map((row, _) -> JdbiLabRunStore.run(row))
                .findOne());
  }

  private static LabRun run(ResultSet row) throws SQLException {
    return new LabRun(
        row.getLong("id"),
        new LabOrder(
            row.getString("experiment"),
            row.getLong("seed"),
            row.getInt("runs"),
            values(row.getString("parameters"))),
        row.getString("user_name"),
        DatabaseTypes.instant(row, "ordered_at"),
        instantOrNull(row, "started_at"),
        instantOrNull(row, "ended_at"),
        LabRunState.valueOf(row.getString("state")),
        row.getString("detail"));
  }

  private static @Nullable Instant instantOrNull(ResultSet row, String column) throws SQLException {
    return row.getObject(column) == null ? null : DatabaseTypes.instant(row, column);
  }

  private static Map<String, Double> values(String json) {
    Map<String, Double> values = new TreeMap<>();
    for (Map.Entry<String, JsonNode> value : JsonMapper.shared().readTree(json).properties()) {
      values.put(value.getKey(), value.getValue().doubleValue());
    }
    return values;
  }

  @Override
  public Optional<String> report(long id) {
    return sql.withHandle(
        h ->
            h.createQuery("select report from lab_runs where id = :id and report is not null")
                .bind("id", id)
                .mapTo(String.class)
                .findOne());
  }

  @Override
  public List<KeptDrawing.Entry> drawings(long id) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select name, title, motion is not null as moving from lab_drawings
                    where run_id = :id order by position
                    """)
                .bind("id", id)
                .map(
                    (row, _) ->
                        new KeptDrawing.Entry(
                            row.getString("name"),
                            row.getString("title"),
                            row.getBoolean("moving")))
                .list());
  }

  @Override
  public Optional<KeptDrawing> drawing(long id, String name) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select name, title, svg, motion from lab_drawings
                    where run_id = :id and name = :name
                    """)
                .bind("id", id)
                .bind("name", name)
                .map(
                    (row, _) ->
                        new KeptDrawing(
                            row.getString("name"),
                            row.getString("title"),
                            row.getString("svg"),
                            row.getString("motion")))
                .findFirst());
  }

  @Override
  public boolean begin(long id, Instant at) {
    return sql.withHandle(
            h ->
                h.createUpdate(
                        """
                        update lab_runs set state = 'RUNNING', started_at = :at
                        where id = :id and state = 'QUEUED'
                        """)
                    .bind("id", id)
                    .bind("at", at)
                    .execute())
        > 0;
  }

  @Override
  public boolean end(long id, LabRunState state, @Nullable String detail, Instant at) {
    return sql.withHandle(
            h ->
                h.createUpdate(
                        """
                        update lab_runs set state = :state, detail = :detail, ended_at = :at
                        where id = :id and state in ('QUEUED', 'RUNNING')
                        """)
                    .bind("state", state.name())
                    .bind("detail", detail == null ? null : cut(detail, LONGEST_DETAIL))
                    .bind("id", id)
                    .bind("at", at)
                    .execute())
        > 0;
  }

  @Override
  public void complete(long id, LabResult result, Instant at) {
    sql.inTransaction(
        h -> {
          int changed =
              h.createUpdate(
                      """
                      update lab_runs set state = 'DONE', report = :report, ended_at = :at
                      where id = :id and state = 'RUNNING'
                      """)
                  .bind("report", result.report())
                  .bind("id", id)
                  .bind("at", at)
                  .execute();
          if (changed > 0 && !result.drawings().isEmpty()) {
            addDrawings(h, id, result.drawings());
          }
          return null;
        });
  }

  private static void addDrawings(Handle h, long id, List<KeptDrawing> drawings) {
    PreparedBatch batch =
        h.prepareBatch(
            """
            insert into lab_drawings (run_id, position, name, title, svg, motion)
            values (:run, :position, :name, :title, :svg, :motion)
            """);
    for (int i = 0; i < drawings.size(); i++) {
      KeptDrawing drawing = drawings.get(i);
      batch
          .bind("run", id)
          .bind("position", i)
          .bind("name", drawing.name())
          .bind("title", cut(drawing.title(), LONGEST_TITLE))
          .bind("svg", drawing.svg())
          .bind("motion", drawing.motion())
          .add();
    }
    batch.execute();
  }

  private static String cut(String text, int longest) {
    return text.length() <= longest ? text : text.substring(0, longest);
  }

  @Override
  public void breakOff(Instant at) {
    sql.withHandle(
        h ->
            h.createUpdate(
                    """
                    update lab_runs set state = 'BROKEN_OFF', ended_at = :at where state = 'RUNNING'
                    """)
                .bind("at", at)
                .execute());
  }

  @Override
  public boolean delete(long id) {
    return sql.withHandle(
            h ->
                h.createUpdate(
                        """
                        delete from lab_runs where id = :id and state not in ('QUEUED', 'RUNNING')
                        """)
                    .bind("id", id)
                    .execute())
        > 0;
  }
}
