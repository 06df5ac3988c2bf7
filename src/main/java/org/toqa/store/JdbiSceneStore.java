package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.jdbi.v3.core.statement.Query;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.FloorScenes;
import org.toqa.fleet.history.LoadPlace;
import org.toqa.fleet.history.PlannedPath;
import org.toqa.fleet.history.SceneStore;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import tools.jackson.databind.json.JsonMapper;

/** What replays show beside tracks, on H2 and on MySQL. */
public final class JdbiSceneStore implements SceneStore {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();
  private static final double MILLIMETRES = 1000;

  private static final String LOADS =
      """
      select load_id, task_id, floor, at, until, x, y, robots, load_length, load_width
      from load_places where\s""";

  private static final String PATHS =
      """
      select r.name, p.floor, p.at, p.until, p.points
      from planned_paths p join robots r on r.id = p.robot_id where\s""";

  private static final String OF_PERIOD =
      "floor = :floor and at < :until and (until is null or until > :from) order by at limit :most";

  private static final String PATHS_OF_PERIOD =
      """
      p.floor = :floor and p.at < :until and (p.until is null or p.until > :from)
      order by p.at limit :most
      """;

  private final SqlExecutor sql;

  public JdbiSceneStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public void save(List<LoadPlace> loads, List<PlannedPath> paths) {
    sql.inTransaction(
        h -> {
          saveLoads(h, loads);
          savePaths(h, paths);
          return true;
        });
  }

  private static void saveLoads(Handle h, List<LoadPlace> loads) {
    PreparedBatch batch =
        h.prepareBatch(
            """
            insert into load_places
              (load_id, at, until, floor, task_id, robots, x, y, load_length, load_width)
            values (:load, :at, :until, :floor, :task, :robots, :x, :y, :length, :width)
            on duplicate key update until = values(until)
            """);
    for (LoadPlace load : loads) {
      Vec2 position = load.position();
      LoadSize size = load.size();
      batch
          .bind("load", load.load())
          .bind("at", load.from().toEpochMilli())
          .bind("until", milliseconds(load.until()))
          .bind("floor", load.floor())
          .bind("task", load.task())
          .bind("robots", RobotNames.write(load.robots()))
          .bind("x", position == null ? null : millimetres(position.x()))
          .bind("y", position == null ? null : millimetres(position.y()))
          .bind("length", size == null ? null : millimetres(size.length()))
          .bind("width", size == null ? null : millimetres(size.width()))
          .add();
    }
    batch.execute();
  }

  /** Those of robots that were removed for good meanwhile are left out. */
  private static void savePaths(Handle h, List<PlannedPath> paths) {
    PreparedBatch batch =
        h.prepareBatch(
            """
            insert into planned_paths (robot_id, at, until, floor, points)
            select id, :at, :until, :floor, :points from robots where name = :robot
            on duplicate key update until = values(until)
            """);
    for (PlannedPath path : paths) {
      batch
          .bind("robot", path.robot())
          .bind("at", path.from().toEpochMilli())
          .bind("until", milliseconds(path.until()))
          .bind("floor", path.floor())
          .bind("points", writePoints(path.simplified().points()))
          .add();
    }
    batch.execute();
  }

  @Override
  public List<LoadPlace> openLoads() {
    return sql.withHandle(
        h -> h.createQuery(LOADS + "until is null").map((rs, context) -> load(rs)).list());
  }

  @Override
  public List<PlannedPath> openPaths() {
    return sql.withHandle(
        h -> h.createQuery(PATHS + "p.until is null").map((rs, context) -> path(rs)).list());
  }

  @Override
  public FloorScenes scenesOf(String floor, Instant from, Instant until, int most) {
    return sql.withHandle(
        h -> {
          List<LoadPlace> loads =
              bind(h.createQuery(LOADS + OF_PERIOD), floor, from, until, most)
                  .map((rs, context) -> load(rs))
                  .list();
          List<PlannedPath> paths =
              bind(h.createQuery(PATHS + PATHS_OF_PERIOD), floor, from, until, most)
                  .map((rs, context) -> path(rs))
                  .list();
          return within(from, until, most, loads, paths);
        });
  }

  private static Query bind(Query query, String floor, Instant from, Instant until, int most) {
    return query
        .bind("floor", floor)
        .bind("from", from.toEpochMilli())
        .bind("until", until.toEpochMilli())
        .bind("most", most + 1);
  }

  /** Up to where nothing was left out. */
  private static FloorScenes within(
      Instant from, Instant until, int most, List<LoadPlace> loads, List<PlannedPath> paths) {
    Instant end =
        Stream.concat(
                loads.stream().skip(most).map(LoadPlace::from),
                paths.stream().skip(most).map(PlannedPath::from))
            .filter(at -> at.isAfter(from))
            .min(Comparator.naturalOrder())
            .orElse(until);
    return new FloorScenes(
        end,
        loads.stream().filter(load -> load.from().isBefore(end)).toList(),
        paths.stream().filter(path -> path.from().isBefore(end)).toList());
  }

  private static LoadPlace load(ResultSet rs) throws SQLException {
    Integer x = rs.getObject("x", Integer.class);
    Integer y = rs.getObject("y", Integer.class);
    Integer length = rs.getObject("load_length", Integer.class);
    Integer width = rs.getObject("load_width", Integer.class);
    return new LoadPlace(
        rs.getLong("load_id"),
        rs.getLong("task_id"),
        rs.getString("floor"),
        Instant.ofEpochMilli(rs.getLong("at")),
        moment(rs),
        x == null || y == null ? null : new Vec2(x / MILLIMETRES, y / MILLIMETRES),
        RobotNames.read(rs.getString("robots")),
        length == null || width == null
            ? null
            : new LoadSize(length / MILLIMETRES, width / MILLIMETRES));
  }

  private static PlannedPath path(ResultSet rs) throws SQLException {
    return new PlannedPath(
        rs.getString("name"),
        rs.getString("floor"),
        Instant.ofEpochMilli(rs.getLong("at")),
        moment(rs),
        readPoints(rs.getString("points")));
  }

  private static @Nullable Instant moment(ResultSet rs) throws SQLException {
    Long until = rs.getObject("until", Long.class);
    return until == null ? null : Instant.ofEpochMilli(until);
  }

  private static @Nullable Long milliseconds(@Nullable Instant moment) {
    return moment == null ? null : Long.valueOf(moment.toEpochMilli());
  }

  private static Integer millimetres(double metres) {
    return Math.toIntExact(Math.round(metres * MILLIMETRES));
  }

  private static String writePoints(List<Vec2> points) {
    return MAPPER.writeValueAsString(
        points.stream()
            .flatMap(point -> Stream.of(millimetres(point.x()), millimetres(point.y())))
            .toList());
  }

  private static List<Vec2> readPoints(String json) {
    int[] all = MAPPER.readValue(json, int[].class);
    return IntStream.range(0, all.length / 2)
        .mapToObj(i -> new Vec2(all[2 * i] / MILLIMETRES, all[2 * i + 1] / MILLIMETRES))
        .toList();
  }
}
