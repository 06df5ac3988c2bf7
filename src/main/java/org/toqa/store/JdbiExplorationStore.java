package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.List;
import org.jdbi.v3.core.Jdbi;
import org.toqa.exploration.ExplorationOrder;
import org.toqa.exploration.ExplorationPicture;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.exploration.Exploration;
import org.toqa.fleet.exploration.ExplorationStore;
import org.toqa.geometry.Vec2;
import tools.jackson.databind.json.JsonMapper;

/** Explorations on H2 and on MySQL. */
public final class JdbiExplorationStore implements ExplorationStore {
  private final SqlExecutor sql;

  public JdbiExplorationStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public List<Exploration> explorations() {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select floor, ground, robots, start_x, start_y, target_x, target_y, seed,
                      user_name, revision, started_at, ended_at, state, draft, picture
                    from explorations
                    """)
                .map((row, _) -> JdbiExplorationStore.exploration(row))
                .list());
  }

  private static Exploration exploration(ResultSet row) throws SQLException {
    return new Exploration(
        row.getString("floor"),
        row.getString("ground"),
        new ExplorationOrder(
            row.getInt("robots"),
            new Vec2(row.getDouble("start_x"), row.getDouble("start_y")),
            new Vec2(row.getDouble("target_x"), row.getDouble("target_y")),
            row.getLong("seed")),
        row.getString("user_name"),
        row.getLong("revision"),
        DatabaseTypes.instant(row, "started_at"),
        row.getObject("ended_at") == null ? null : DatabaseTypes.instant(row, "ended_at"),
        Exploration.State.valueOf(row.getString("state")),
        JsonMapper.shared().readValue(row.getString("picture"), ExplorationPicture.class),
        Exploration.Draft.valueOf(row.getString("draft")));
  }

  @Override
  public void remove(String floor) {
    sql.inTransaction(h -> h.execute("delete from explorations where floor = ?", floor));
  }

  @Override
  public void save(Exploration exploration, List<EventRecord> events) {
    ExplorationOrder order = exploration.order();
    sql.inTransaction(
        h -> {
          h.createUpdate("delete from explorations where floor = :floor")
              .bind("floor", exploration.floor())
              .execute();
          h.createUpdate(
                  """
                  insert into explorations (floor, ground, robots, start_x, start_y, target_x,
                    target_y, seed, user_name, revision, started_at, ended_at, state, draft, picture)
                  values (:floor, :ground, :robots, :startX, :startY, :targetX, :targetY, :seed,
                    :user, :revision, :started, :ended, :state, :draft, :picture)
                  """)
              .bind("floor", exploration.floor())
              .bind("ground", exploration.ground())
              .bind("robots", order.robots())
              .bind("startX", order.start().x())
              .bind("startY", order.start().y())
              .bind("targetX", order.target().x())
              .bind("targetY", order.target().y())
              .bind("seed", order.seed())
              .bind("user", exploration.user())
              .bind("revision", exploration.revision())
              .bind("started", exploration.startedAt())
              .bind("ended", exploration.endedAt())
              .bind("state", exploration.state().name())
              .bind("draft", exploration.draft().name())
              .bind("picture", JsonMapper.shared().writeValueAsString(exploration.picture()))
              .execute();
          EventTable.addMissing(h, events);
          return null;
        });
  }
}
