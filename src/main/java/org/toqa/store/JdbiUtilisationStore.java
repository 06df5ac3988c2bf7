package org.toqa.store;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.UtilisationRecord;
import org.toqa.fleet.history.UtilisationStore;

/** What robots did, on H2 and on MySQL: a row for each robot and half hour. */
public final class JdbiUtilisationStore implements UtilisationStore {
  private static final double MILLIMETRES = 1000;

  private static final String SAVE =
      """
      insert into robot_use (at, robot_id, way_mm, battery, %s)
      select :at, id, :way, :battery, %s from robots where name = :robot
      on duplicate key update way_mm = values(way_mm), battery = values(battery), %s
      """
          .formatted(columns("%1$s"), columns(":%1$s"), columns("%1$s = values(%1$s)"));

  private final SqlExecutor sql;

  public JdbiUtilisationStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public void save(List<UtilisationRecord> records) {
    sql.inTransaction(
        h -> {
          PreparedBatch batch = h.prepareBatch(SAVE);
          for (UtilisationRecord record : records) {
            for (RobotActivity use : RobotActivity.values()) {
              batch.bind(column(use), record.time().getOrDefault(use, Duration.ZERO).toMillis());
            }
            batch
                .bind("at", record.at())
                .bind("robot", record.robot())
                .bind("way", Math.round(record.metres() * MILLIMETRES))
                .bind("battery", record.battery())
                .add();
          }
          return batch.execute();
        });
  }

  /** One for each use, in their order: the pattern with its column. */
  static String columns(String pattern) {
    return Stream.of(RobotActivity.values())
        .map(use -> pattern.formatted(column(use)))
        .collect(Collectors.joining(", "));
  }

  static String column(RobotActivity use) {
    return use.name().toLowerCase(Locale.ROOT) + "_ms";
  }
}
