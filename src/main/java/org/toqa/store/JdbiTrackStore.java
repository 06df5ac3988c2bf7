package org.toqa.store;

import java.time.Instant;
import java.util.List;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.toqa.fleet.TrackPoint;
import org.toqa.fleet.TrackStore;
import org.toqa.geometry.Vec2;

/** Tracks on H2 and on MySQL: 24 bytes a point, and what the database adds to a row. */
public final class JdbiTrackStore implements TrackStore {
  private static final double MILLIMETRES = 1000;

  private final Sql sql;

  public JdbiTrackStore(Jdbi jdbi) {
    this.sql = new Sql(jdbi);
  }

  @Override
  public void add(List<TrackPoint> points) {
    sql.inTransaction(
        h -> {
          PreparedBatch batch =
              h.prepareBatch(
                  """
                  insert ignore into tracks (robot_id, at, x, y)
                  select id, :at, :x, :y from robots where name = :robot
                  """);
          for (TrackPoint point : points) {
            batch
                .bind("robot", point.robot())
                .bind("at", point.at().toEpochMilli())
                .bind("x", Math.round(point.position().x() * MILLIMETRES))
                .bind("y", Math.round(point.position().y() * MILLIMETRES))
                .add();
          }
          return batch.execute();
        });
  }

  @Override
  public List<TrackPoint> track(String robot, Instant since) {
    return sql.in(
        h ->
            h.createQuery(
                    """
                    select t.at, t.x, t.y from tracks t join robots r on r.id = t.robot_id
                    where r.name = :robot and t.at >= :since order by t.at
                    """)
                .bind("robot", robot)
                .bind("since", since.toEpochMilli())
                .map(
                    (rs, context) ->
                        new TrackPoint(
                            robot,
                            Instant.ofEpochMilli(rs.getLong("at")),
                            new Vec2(rs.getInt("x") / MILLIMETRES, rs.getInt("y") / MILLIMETRES)))
                .list());
  }
}
