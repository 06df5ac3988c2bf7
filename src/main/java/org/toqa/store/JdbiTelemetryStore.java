package org.toqa.store;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.telemetry.ReadingLimits;
import org.toqa.telemetry.TelemetryStore;
import org.toqa.wording.Phrase;

/** By which passwords robots publish, and the limits of their readings. */
public final class JdbiTelemetryStore implements TelemetryStore {
  private final SqlExecutor sql;
  private final InstantSource clock;

  public JdbiTelemetryStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  @Override
  public Optional<String> passwordHash(String robot) {
    return sql.withHandle(
        h ->
            h.createQuery("select password_hash from mqtt_passwords where robot = :robot")
                .bind("robot", robot)
                .mapTo(String.class)
                .findOne());
  }

  @Override
  public void setPasswordHash(String robot, String hash, String by) {
    sql.inTransaction(
        h -> {
          Instant now = clock.instant();
          h.execute("delete from mqtt_passwords where robot = ?", robot);
          h.createUpdate(
                  """
                  insert into mqtt_passwords (robot, password_hash, made_at)
                  values (:robot, :hash, :now)
                  """)
              .bind("robot", robot)
              .bind("hash", hash)
              .bind("now", now)
              .execute();
          EventTable.addAll(
              h,
              List.of(
                  new EventRecord(
                      now,
                      EventKind.ROBOT_MQTT_PASSWORD,
                      null,
                      robot,
                      by,
                      Phrase.ROBOT_MQTT_PASSWORD.with(by, robot))));
          return null;
        });
  }

  @Override
  public List<ReadingLimits> limits() {
    return sql.withHandle(
        h ->
            h.createQuery(
                    "select robot, reading, low, high from reading_limits order by robot, reading")
                .map(
                    (row, _) ->
                        new ReadingLimits(
                            row.getString("robot"),
                            row.getString("reading"),
                            row.getObject("low", Double.class),
                            row.getObject("high", Double.class)))
                .list());
  }

  @Override
  public void setLimits(ReadingLimits limits) {
    sql.inTransaction(
        h -> {
          h.execute(
              "delete from reading_limits where robot = ? and reading = ?",
              limits.robot(),
              limits.reading());
          if (!limits.isNone()) {
            h.createUpdate(
                    """
                    insert into reading_limits (robot, reading, low, high)
                    values (:robot, :reading, :low, :high)
                    """)
                .bind("robot", limits.robot())
                .bind("reading", limits.reading())
                .bind("low", limits.low())
                .bind("high", limits.high())
                .execute();
          }
          return null;
        });
  }
}
