package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.toqa.fleet.history.BatteryLevel;
import org.toqa.fleet.history.FloorTracks;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.fleet.history.TrackStore;
import org.toqa.geometry.Vec2;

/** Tracks on H2 and on MySQL: 24 bytes a point, and what the database adds to a row. */
public final class JdbiTrackStore implements TrackStore {
  private static final double MILLIMETRES = 1000;
  private static final double PERCENT = 100;

  private final SqlExecutor sql;

  public JdbiTrackStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public List<String> robotsOf(String floor) {
    return sql.withHandle(
        h ->
            h.createQuery("select name from robots where floor = :floor order by name")
                .bind("floor", floor)
                .mapTo(String.class)
                .list());
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
  public void addBatteryLevels(List<BatteryLevel> levels) {
    sql.inTransaction(
        h -> {
          PreparedBatch batch =
              h.prepareBatch(
                  """
                  insert ignore into battery_levels (robot_id, at, percent)
                  select id, :at, :percent from robots where name = :robot
                  """);
          for (BatteryLevel level : levels) {
            batch
                .bind("robot", level.robot())
                .bind("at", level.at().toEpochMilli())
                .bind("percent", Math.round(level.level() * PERCENT))
                .add();
          }
          return batch.execute();
        });
  }

  @Override
  public List<BatteryLevel> batteryLevels(String robot, Instant since) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select b.at, b.percent from battery_levels b join robots r on r.id = b.robot_id
                    where r.name = :robot and b.at >= coalesce(
                      (select max(p.at) from battery_levels p
                       where p.robot_id = r.id and p.at < :since), :since)
                    order by b.at
                    """)
                .bind("robot", robot)
                .bind("since", since.toEpochMilli())
                .map(
                    (rs, context) ->
                        new BatteryLevel(
                            robot,
                            Instant.ofEpochMilli(rs.getLong("at")),
                            rs.getInt("percent") / PERCENT))
                .list());
  }

  @Override
  public List<TrackPoint> track(String robot, Instant since) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select t.at, t.x, t.y from tracks t join robots r on r.id = t.robot_id
                    where r.name = :robot and t.at >= :since order by t.at
                    """)
                .bind("robot", robot)
                .bind("since", since.toEpochMilli())
                .map((rs, context) -> point(robot, rs))
                .list());
  }

  @Override
  public FloorTracks tracksOf(List<String> robots, Instant from, Instant until, int most) {
    return robots.isEmpty()
        ? new FloorTracks(until, Map.of())
        : sql.withHandle(h -> tracks(h, robots, from, until, most));
  }

  private static FloorTracks tracks(
      Handle h, List<String> robots, Instant from, Instant until, int most) {
    List<TrackPoint> within = pointsWithin(h, robots, from, until, most + 1);
    Instant end = within.size() <= most ? until : within.getLast().at();
    Map<String, List<TrackPoint>> moved =
        within.stream()
            .filter(point -> point.at().isBefore(end))
            .collect(Collectors.groupingBy(TrackPoint::robot));
    Map<String, List<TrackPoint>> points = new LinkedHashMap<>();
    for (String robot : robots) {
      List<TrackPoint> track = new ArrayList<>();
      track.addAll(
          pointsBeside(h, robot, "t.at < :at order by t.at desc limit 2", from).reversed());
      track.addAll(moved.getOrDefault(robot, List.of()));
      track.addAll(pointsBeside(h, robot, "t.at >= :at order by t.at limit 1", end));
      points.put(robot, track);
    }
    return new FloorTracks(end, points);
  }

  private static List<TrackPoint> pointsWithin(
      Handle h, List<String> robots, Instant from, Instant until, int limit) {
    return h.createQuery(
            """
            select r.name, t.at, t.x, t.y from tracks t join robots r on r.id = t.robot_id
            where r.name in (<robots>) and t.at >= :from and t.at < :until
            order by t.at limit :limit
            """)
        .bindList("robots", robots)
        .bind("from", from.toEpochMilli())
        .bind("until", until.toEpochMilli())
        .bind("limit", limit)
        .map((rs, context) -> point(rs.getString("name"), rs))
        .list();
  }

  private static List<TrackPoint> pointsBeside(Handle h, String robot, String where, Instant at) {
    return h.createQuery(
            "select t.at, t.x, t.y from tracks t join robots r on r.id = t.robot_id"
                + " where r.name = :robot and "
                + where)
        .bind("robot", robot)
        .bind("at", at.toEpochMilli())
        .map((rs, context) -> point(robot, rs))
        .list();
  }

  private static TrackPoint point(String robot, ResultSet rs) throws SQLException {
    return new TrackPoint(
        robot,
        Instant.ofEpochMilli(rs.getLong("at")),
        new Vec2(rs.getInt("x") / MILLIMETRES, rs.getInt("y") / MILLIMETRES));
  }
}
