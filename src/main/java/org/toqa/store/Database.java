package org.toqa.store;

import com.zaxxer.hikari.HikariConfig;
import com.zaxxer.hikari.HikariDataSource;
import com.zaxxer.hikari.metrics.micrometer.MicrometerMetricsTrackerFactory;
import io.micrometer.core.instrument.MeterRegistry;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import javax.sql.DataSource;
import org.flywaydb.core.Flyway;
import org.jdbi.v3.core.Jdbi;
import org.jspecify.annotations.Nullable;

/** The database: a pool of connections, migrated to the newest {@code sql/}. */
public final class Database implements AutoCloseable {
  private static final int FLYWAY_CONNECTIONS = 3;
  private static final List<String> IDENTITY_TABLES = List.of("tasks", "events");
  private static final int IDENTITY_CACHE = 1000;

  private static final String MYSQL = "jdbc:mysql:";

  /** A database that does not answer for so long is away; what was asked is tried again. */
  private static final Duration SOCKET_TIMEOUT = Duration.ofSeconds(8);

  private static final Duration CONNECT_TIMEOUT = Duration.ofSeconds(3);

  private final HikariDataSource pool;
  private final Jdbi jdbi;

  /** Null where the database is not a file of this process. */
  private final @Nullable H2Compactor compactor;

  private Database(HikariDataSource pool, boolean isOwnFile) {
    this.pool = pool;
    this.jdbi = Jdbi.create((DataSource) pool);
    DatabaseTypes.register(jdbi);
    this.compactor = isOwnFile ? new H2Compactor(jdbi) : null;
  }

  /**
   * @param database its JDBC URL; what that of an H2 database does not say is as Toqa needs it
   * @param user empty: the one in the URL, if any
   */
  public static Database open(String database, String user, String password) {
    String url = H2Url.isH2(database) ? H2Url.withSettings(database) : database;
    try (HikariDataSource migrationPool = new HikariDataSource(config(url, user, password))) {
      Flyway.configure(Database.class.getClassLoader())
          .dataSource(migrationPool)
          .locations("classpath:sql")
          .load()
          .migrate();
      if (!url.startsWith(MYSQL)) {
        closeIdentityGaps(Jdbi.create((DataSource) migrationPool));
      }
    }
    HikariConfig config = config(url, user, password);
    config.setMaximumPoolSize(10);
    config.setConnectionTimeout(CONNECT_TIMEOUT.plusSeconds(1).toMillis());
    config.setValidationTimeout(CONNECT_TIMEOUT.toMillis());
    if (url.startsWith(
        MYSQL)) { // without limits a connection to a machine that is gone waits for ever
      config.addDataSourceProperty("connectTimeout", milliseconds(CONNECT_TIMEOUT));
      config.addDataSourceProperty("socketTimeout", milliseconds(SOCKET_TIMEOUT));
    }
    return new Database(new HikariDataSource(config), H2Url.isOwnFile(url));
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

  /** An H2 database that lives as long as it is open. */
  public static Database inMemory(String name) {
    return open(H2Url.inMemory(name), "toqa", "");
  }

  /** The innermost cause, which is the database's own word, in one line. */
  public static String rootCauseMessage(Throwable failure) {
    Throwable cause = failure;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    return String.valueOf(cause.getMessage()).lines().findFirst().orElse(cause.toString());
  }

  public Jdbi jdbi() {
    return jdbi;
  }

  /** Tells how the pool of connections does from now on. */
  public void bindMetrics(MeterRegistry registry) {
    pool.setMetricsTrackerFactory(new MicrometerMetricsTrackerFactory(registry));
  }

  @Override
  public void close() {
    if (compactor != null) {
      compactor.close();
    }
    pool.close();
  }
}
