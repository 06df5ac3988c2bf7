package org.toqa.store;

import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Types;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import java.util.Optional;
import java.util.UUID;
import java.util.function.Function;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.argument.Argument;
import org.jdbi.v3.core.argument.ArgumentFactory;
import org.jdbi.v3.core.argument.NullArgument;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.accounts.Site;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.Hold;
import org.toqa.fleet.RobotRecord;
import org.toqa.link.http.RobotToken;
import org.toqa.link.trust.Fingerprint;
import org.toqa.mission.Phase;
import org.toqa.motion.Trajectory;

/** How values are kept in columns, and which records are read from rows by the names of columns. */
final class DatabaseTypes {
  private DatabaseTypes() {}

  static void register(Jdbi jdbi) {
    // Not the library's own reading of moments, which goes by the time zone of the process.
    jdbi.registerArgument(argument(Instant.class, Types.TIMESTAMP, DatabaseTypes::utc));
    jdbi.registerColumnMapper(
        Instant.class,
        (row, column, context) -> {
          LocalDateTime at = row.getObject(column, LocalDateTime.class);
          return at == null ? null : at.toInstant(ZoneOffset.UTC);
        });
    jdbi.registerArgument(argument(UUID.class, Types.VARCHAR, UUID::toString));
    jdbi.registerArgument(argument(Fingerprint.class, Types.VARCHAR, Fingerprint::hex));
    jdbi.registerColumnMapper(
        Fingerprint.class,
        (row, column, context) -> {
          String hex = row.getString(column);
          return hex == null ? null : new Fingerprint(hex);
        });
    jdbi.registerArgument(argument(RobotToken.class, Types.VARCHAR, RobotToken::secret));
    jdbi.registerColumnMapper(
        RobotToken.class,
        (row, column, context) -> {
          String secret = row.getString(column);
          return secret == null ? null : new RobotToken(secret);
        });
    jdbi.registerArgument(argument(Phase.class, Types.INTEGER, Phase::number));
    jdbi.registerColumnMapper(
        Phase.class, (row, column, context) -> Phase.stored(row.getInt(column)));
    jdbi.registerArgument(argument(Trajectory.class, Types.VARCHAR, TrajectoryJson::write));
    jdbi.registerColumnMapper(
        Trajectory.class,
        (row, column, context) -> {
          String way = row.getString(column);
          return way == null ? null : TrajectoryJson.read(way);
        });

    register(jdbi, RobotRecord.class);
    register(jdbi, Hold.class);
    register(jdbi, StoredDrive.class);
    register(jdbi, DriveTable.End.class);
    register(jdbi, RobotTable.StoredRobotRow.class);
    register(jdbi, TaskRow.class);
    register(jdbi, JdbiOrderArchive.OrderRow.class);
    register(jdbi, TaskTable.AssignedRobotRow.class);
    register(jdbi, ScheduleRow.class);
    register(jdbi, TaskTemplateRow.class);
    register(jdbi, LeftBehind.Item.class);
    register(jdbi, EventTable.EventRow.class);
    register(jdbi, JdbiSessionStore.ListedSessionRow.class);
    register(jdbi, JdbiSessionStore.OwnedSessionRow.class);
    register(jdbi, Account.class);
    register(jdbi, Site.class);
  }

  private static <T> void register(Jdbi jdbi, Class<T> type) {
    jdbi.registerRowMapper(type, new RowMapperCache<>(type));
  }

  /**
   * The moment in a column that is not null.
   *
   * @throws SQLException when there is no such column
   */
  static Instant instant(ResultSet row, String column) throws SQLException {
    return row.getObject(column, LocalDateTime.class).toInstant(ZoneOffset.UTC);
  }

  /** UTC, milliseconds. */
  private static LocalDateTime utc(Instant instant) {
    return LocalDateTime.ofInstant(instant.truncatedTo(ChronoUnit.MILLIS), ZoneOffset.UTC);
  }

  /**
   * Binds values of a type.
   *
   * @param sqlType of {@link Types}, for values that are null
   * @param column the value as the column has it
   */
  private static <T> ArgumentFactory argument(
      Class<T> type, int sqlType, Function<T, Object> column) {
    // Prepared, since of the library's own factories those that are come first.
    return (ArgumentFactory.Preparable)
        (given, config) ->
            given.equals(type)
                ? Optional.of(value -> argument(type, sqlType, column, value))
                : Optional.empty();
  }

  private static <T> Argument argument(
      Class<T> type, int sqlType, Function<T, Object> column, @Nullable Object value) {
    return value == null
        ? new NullArgument(sqlType)
        : (position, statement, context) ->
            statement.setObject(position, column.apply(type.cast(value)));
  }
}
