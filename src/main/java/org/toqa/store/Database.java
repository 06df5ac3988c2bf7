package org.toqa.store;

import com.zaxxer.hikari.HikariConfig;
import com.zaxxer.hikari.HikariDataSource;
import com.zaxxer.hikari.metrics.micrometer.MicrometerMetricsTrackerFactory;
import io.micrometer.core.instrument.MeterRegistry;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.SQLException;
import java.time.Duration;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CompletionStage;
import javax.sql.DataSource;
import org.flywaydb.core.Flyway;
import org.h2.api.ErrorCode;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Site;
import org.toqa.fleet.PeriodicWork;

/**
 * The database, migrated to the newest {@code sql/}. The fleet, readers and sessions have pools of
 * connections of their own, so that none of them keeps another waiting, and each statement has a
 * time limit.
 */
public final class Database implements AutoCloseable {
  private static final int FLYWAY_CONNECTIONS = 3;
  private static final List<String> IDENTITY_TABLES = List.of("tasks", "events");
  private static final int IDENTITY_CACHE = 1000;

  private static final String MYSQL = "jdbc:mysql:";

  private static final int FLEET_CONNECTIONS = 10;
  private static final int READER_CONNECTIONS = 5;
  private static final int SESSION_CONNECTIONS = 5;

  /** Of each pool; others are opened when they are needed. */
  private static final int MIN_IDLE = 2;

  /** For a statement of the fleet or of a session. */
  private static final Duration WRITE_LIMIT = Duration.ofSeconds(6);

  /** A database that does not answer for so long beyond the limit is away. */
  private static final Duration SOCKET_MARGIN = Duration.ofSeconds(2);

  private static final Duration CONNECT_TIMEOUT = Duration.ofSeconds(3);

  /** For a statement of those who only look. */
  static final Duration READ_LIMIT = Duration.ofSeconds(20);

  private final Pool fleet;
  private final Pool readers;
  private final Pool sessions;

  /** Null where the database is not a file of this process. */
  private final @Nullable H2Compactor compactor;

  private final @Nullable PeriodicWork compaction;

  private final boolean isMySql;
  private final ClosedH2 closed = new ClosedH2();

  private record Pool(HikariDataSource connections, Jdbi jdbi) implements AutoCloseable {
    static Pool of(HikariConfig config) {
      HikariDataSource connections = new HikariDataSource(config);
      Jdbi jdbi = Jdbi.create((DataSource) connections);
      DatabaseTypes.register(jdbi);
      return new Pool(connections, jdbi);
    }

    @Override
    public void close() {
      connections.close();
    }
  }

  /**
   * One that is migrated already.
   *
   * @param readLimit what a statement of a reader may take
   */
  Database(String url, String user, String password, Duration readLimit) {
    isMySql = url.startsWith(MYSQL);
    fleet = pool(config(url, user, password, "toqa", FLEET_CONNECTIONS, WRITE_LIMIT));
    readers = pool(config(url, user, password, "toqa-readers", READER_CONNECTIONS, readLimit));
    sessions = pool(config(url, user, password, "toqa-sessions", SESSION_CONNECTIONS, WRITE_LIMIT));
    compactor = H2Url.isOwnFile(url) ? new H2Compactor(fleet.jdbi()) : null;
    compaction =
        compactor == null
            ? null
            : new PeriodicWork("h2-compactor", H2Compactor.INTERVAL, compactor::compact);
  }

  private Pool pool(HikariConfig config) {
    if (!isMySql) {
      config.setExceptionOverride(closed);
    }
    return Pool.of(config);
  }

  /** Whether that is the JDBC URL of a kind of database that can be used. */
  public static boolean isSupported(String url) {
    return url.startsWith(MYSQL) || H2Url.isH2(url);
  }

  /**
   * @param database its JDBC URL; what that of an H2 database does not say is as Toqa needs it
   * @param user empty: the one in the URL, if any
   */
  public static Database open(String database, String user, String password) {
    String url = H2Url.isH2(database) ? H2Url.withSettings(database) : database;
    migrate(url, user, password);
    return new Database(url, user, password, READ_LIMIT);
  }

  private static void migrate(String url, String user, String password) {
    H2Migration.Replacement newer;
    try (HikariDataSource pool = new HikariDataSource(config(url, user, password))) {
      if (!H2Url.isOwnFile(url) || flyway(pool).info().pending().length == 0) {
        migrate(pool, url);
        return;
      }
      newer = H2Migration.migrateCopy(url, pool, copy -> migrateCopy(copy, user, password));
      H2Migration.shutDown(pool);
    }
    newer.carryOut();
  }

  private static void migrateCopy(String url, String user, String password) {
    try (HikariDataSource pool = new HikariDataSource(config(url, user, password))) {
      migrate(pool, url);
      H2Migration.shutDown(pool);
    }
  }

  private static void migrate(DataSource source, String url) {
    flyway(source).migrate();
    if (!url.startsWith(MYSQL)) {
      closeIdentityGaps(Jdbi.create(source));
    }
  }

  private static Flyway flyway(DataSource source) {
    return Flyway.configure(Database.class.getClassLoader())
        .dataSource(source)
        .locations("classpath:sql")
        .load();
  }

  /**
   * @param limit of one statement, by the database; MySQL ends those that only read, others end
   *     with their connection
   */
  private static HikariConfig config(
      String url, String user, String password, String name, int connections, Duration limit) {
    HikariConfig config = config(url, user, password);
    config.setPoolName(name);
    config.setMaximumPoolSize(connections);
    config.setMinimumIdle(Math.min(connections, MIN_IDLE));
    config.setConnectionTimeout(CONNECT_TIMEOUT.plusSeconds(1).toMillis());
    config.setValidationTimeout(CONNECT_TIMEOUT.toMillis());
    if (url.startsWith(
        MYSQL)) { // without limits a connection to a machine that is gone waits for ever
      config.addDataSourceProperty("connectTimeout", milliseconds(CONNECT_TIMEOUT));
      config.addDataSourceProperty("socketTimeout", milliseconds(limit.plus(SOCKET_MARGIN)));
      config.setConnectionInitSql("set session max_execution_time = " + limit.toMillis());
    } else {
      config.setConnectionInitSql("set query_timeout " + limit.toMillis());
    }
    return config;
  }

  /**
   * H2 takes ids in stocks, and a killed process loses the rest of its stock. A large stock, since
   * fetching one is a transaction of its own; what was lost of it is given back here.
   */
  private static void closeIdentityGaps(Jdbi jdbi) {
    jdbi.useHandle(
        h -> {
          for (String table : IDENTITY_TABLES) {
            long next =
                h.createQuery("select coalesce(max(id), 0) + 1 from " + table)
                    .mapTo(Long.class)
                    .one();
            h.execute("alter table " + table + " alter column id set cache " + IDENTITY_CACHE);
            h.execute("alter table " + table + " alter column id restart with " + next);
          }
        });
  }

  /** Connections that wait as long as it takes, as a migration may. */
  private static HikariConfig config(String url, String user, String password) {
    HikariConfig config = new HikariConfig();
    config.setPoolName("toqa");
    config.setJdbcUrl(url);
    // Named, since the container's DriverManager does not look into a web application.
    config.setDriverClassName(url.startsWith(MYSQL) ? "com.mysql.cj.jdbc.Driver" : "org.h2.Driver");
    if (!user.isEmpty()) { // else the URL may name one
      config.setUsername(user);
      config.setPassword(password);
    }
    config.setMaximumPoolSize(FLYWAY_CONNECTIONS);
    config.setMinimumIdle(0); // one made in advance would open a file again that was shut down
    return config;
  }

  /** As text: what is none, a driver finds under no name. */
  private static String milliseconds(Duration limit) {
    return String.valueOf(limit.toMillis());
  }

  /**
   * The JDBC URL of an H2 database in a file.
   *
   * @param file without its ending {@code .mv.db}
   */
  public static String fileUrl(Path file) {
    return H2Url.ofFile(file);
  }

  /**
   * The JDBC URL of a site's database: beside the first one's, with the site's id in its name.
   *
   * @param first that of the first site's
   */
  public static String siteUrl(String first, Site site) {
    return SiteUrl.of(first, site);
  }

  /** Whether a file was not opened since another process has it open. */
  public static boolean isInUseElsewhere(Throwable failure) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      if (cause instanceof SQLException e
          && e.getErrorCode() == ErrorCode.DATABASE_ALREADY_OPEN_1) {
        return true;
      }
    }
    return false;
  }

  /** The innermost cause, which is the database's own word, in one line. */
  public static String rootCauseMessage(Throwable failure) {
    Throwable cause = failure;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    return String.valueOf(cause.getMessage()).lines().findFirst().orElse(cause.toString());
  }

  /** For the fleet, and for what is written beside it. */
  public Jdbi jdbi() {
    return fleet.jdbi();
  }

  /**
   * For pages and programs that look at what was, and for what people keep there that no robot
   * waits for; they may wait for each other.
   */
  public Jdbi readers() {
    return readers.jdbi();
  }

  /** For users and their sessions, which every request needs. */
  public Jdbi sessions() {
    return sessions.jdbi();
  }

  /** Whether H2 has closed its file by itself, since it cannot write it: nothing can be stored. */
  public boolean isClosedByItself() {
    return closed.isFound();
  }

  /** Completes when that is found out. */
  public CompletionStage<Void> whenClosedByItself() {
    return closed.whenFound();
  }

  /** Tells how the pools of connections do from now on. */
  public void bindMetrics(MeterRegistry registry) {
    for (Pool pool : List.of(fleet, readers, sessions)) {
      pool.connections().setMetricsTrackerFactory(new MicrometerMetricsTrackerFactory(registry));
    }
  }

  /**
   * What it takes, as long as it is open.
   *
   * @throws UncheckedIOException its file cannot be read or copied
   * @throws IllegalStateException it is H2's and no file, or another process's
   */
  public DatabaseSize size() {
    return readers.jdbi().withHandle(h -> isMySql ? DatabaseSize.ofMySql(h) : sizeOfH2File(h));
  }

  /**
   * Bytes of its file, as long as it is open; empty: it is none of this process.
   *
   * @throws UncheckedIOException its file cannot be read
   */
  public OptionalLong fileSize() {
    if (compactor == null) {
      return OptionalLong.empty();
    }
    try {
      return OptionalLong.of(Files.size(readers.jdbi().withHandle(Database::h2File)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Path h2File(Handle h) {
    return Path.of(h.createQuery("select database_path()").mapTo(String.class).one() + ".mv.db");
  }

  private DatabaseSize sizeOfH2File(Handle h) {
    if (compactor == null) {
      throw new IllegalStateException("This database is no file of this process.");
    }
    try {
      return DatabaseSize.ofH2File(h2File(h));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    if (compactor != null && compaction != null) {
      compaction.close();
      compactor.close();
    }
    sessions.close();
    readers.close();
    fleet.close();
  }
}
