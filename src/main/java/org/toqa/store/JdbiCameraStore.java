package org.toqa.store;

import java.net.URI;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.toqa.camera.Camera;
import org.toqa.camera.CameraOrder;
import org.toqa.camera.CameraStore;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Cameras; who added, changed and removed them is in the history. */
public final class JdbiCameraStore implements CameraStore {
  private static final String SELECT = "select id, name, url, robot, floor from cameras";

  private final SqlExecutor sql;
  private final InstantSource clock;

  public JdbiCameraStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  @Override
  public List<Camera> cameras() {
    return sql.withHandle(
        h -> h.createQuery(SELECT + " order by name").map((row, _) -> camera(row)).list());
  }

  private static Camera camera(ResultSet row) throws SQLException {
    return new Camera(
        row.getLong("id"),
        new CameraOrder(
            row.getString("name"),
            URI.create(row.getString("url")),
            row.getString("robot"),
            row.getString("floor")));
  }

  @Override
  public Camera add(CameraOrder order, String by) {
    return sql.inTransaction(
        h -> {
          long id =
              h.createUpdate(
                      """
                      insert into cameras (name, url, robot, floor)
                      values (:name, :url, :robot, :floor)
                      """)
                  .bind("name", order.name())
                  .bind("url", order.url().toString())
                  .bind("robot", order.robot())
                  .bind("floor", order.floor())
                  .executeAndReturnGeneratedKeys("id")
                  .mapTo(Long.class)
                  .one();
          tell(h, EventKind.CAMERA_ADDED, order, by, Phrase.CAMERA_ADDED.with(by, order.name()));
          return new Camera(id, order);
        });
  }

  @Override
  public boolean change(Camera camera, String by) {
    return sql.inTransaction(
        h -> {
          Optional<Camera> before = lock(h, camera.id());
          before.ifPresent(
              earlier -> {
                CameraOrder order = camera.order();
                h.execute(
                    "update cameras set name = ?, url = ?, robot = ?, floor = ? where id = ?",
                    order.name(),
                    order.url().toString(),
                    order.robot(),
                    order.floor(),
                    camera.id());
                Sentence said =
                    order.name().equals(earlier.name())
                        ? Phrase.CAMERA_CHANGED.with(by, order.name())
                        : Phrase.CAMERA_RENAMED.with(by, earlier.name(), order.name());
                tell(h, EventKind.CAMERA_CHANGED, order, by, said);
              });
          return before.isPresent();
        });
  }

  private static Optional<Camera> lock(Handle h, long id) {
    return h.createQuery(SELECT + " where id = :id for update")
        .bind("id", id)
        .map((row, _) -> camera(row))
        .findOne();
  }

  @Override
  public boolean delete(long id, String by) {
    return sql.inTransaction(
        h -> {
          Optional<Camera> before = lock(h, id);
          before.ifPresent(
              camera -> {
                h.execute("delete from cameras where id = ?", id);
                CameraOrder order = camera.order();
                Sentence said = Phrase.CAMERA_REMOVED.with(by, order.name());
                tell(h, EventKind.CAMERA_REMOVED, order, by, said);
              });
          return before.isPresent();
        });
  }

  private void tell(Handle h, EventKind kind, CameraOrder order, String by, Sentence said) {
    EventRecord event = new EventRecord(clock.instant(), kind, null, order.robot(), by, said);
    EventTable.addAll(h, List.of(order.floor() == null ? event : event.onFloor(order.floor())));
  }
}
