package org.toqa.store;

import com.zaxxer.hikari.HikariConfig;
import com.zaxxer.hikari.HikariDataSource;
import java.time.Duration;
import javax.sql.DataSource;
import org.flywaydb.core.Flyway;
import org.jdbi.v3.core.Jdbi;

/** The database: a pool of connections, migrated to the newest {@code sql/}. */
public final class Database implements AutoCloseable {
  private static final String H2_OPTIONS =
      ";MODE=MySQL;DATABASE_TO_LOWER=TRUE;CASE_INSENSITIVE_IDENTIFIERS=TRUE";

  private final HikariDataSource pool;
  private final Jdbi jdbi;

  private Database(HikariDataSource pool) {
    this.pool = pool;
    this.jdbi = Jdbi.create((DataSource) pool);
  }

  /**
   * @param url JDBC
   * @param user empty: the one in the URL, if any
   */
  public static Database open(String url, String user, String password) {
    HikariConfig config = new HikariConfig();
    config.setPoolName("toqa");
    config.setJdbcUrl(url);
    // Named, since the container's DriverManager does not look into a web application.
    config.setDriverClassName(
        url.startsWith("jdbc:mysql:") ? "com.mysql.cj.jdbc.Driver" : "org.h2.Driver");
    if (!user.isEmpty()) { // else the URL may name one
      config.setUsername(user);
      config.setPassword(password);
    }
    config.setMaximumPoolSize(10);
    config.setConnectionTimeout(Duration.ofSeconds(5).toMillis());
    HikariDataSource pool = new HikariDataSource(config);
    try {
      Flyway.configure(Database.class.getClassLoader())
          .dataSource(pool)
          .locations("classpath:sql")
          .load()
          .migrate();
    } catch (RuntimeException e) {
      pool.close();
      throw e;
    }
    return new Database(pool);
  }

  /** An H2 database that lives as long as it is open. */
  public static Database inMemory(String name) {
    return open("jdbc:h2:mem:" + name + H2_OPTIONS + ";DB_CLOSE_DELAY=-1", "toqa", "");
  }

  /** The innermost cause, which is the database's own word, in one line. */
  public static String reason(Throwable failure) {
    Throwable cause = failure;
    while (cause.getCause() != null) {
      cause = cause.getCause();
    }
    return String.valueOf(cause.getMessage()).lines().findFirst().orElse(cause.toString());
  }

  public Jdbi jdbi() {
    return jdbi;
  }

  @Override
  public void close() {
    pool.close();
  }
}
