package org.toqa.store;

import java.sql.SQLException;
import java.time.Duration;
import org.h2.engine.SessionLocal;
import org.h2.jdbc.JdbcConnection;
import org.h2.mvstore.MVStore;
import org.h2.mvstore.MVStoreException;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;

/**
 * Gives back what the file of an H2 database does not need any more. H2 appends all that changes,
 * and has a thread of its own for what is left behind, but not with {@code WRITE_DELAY=0}, where
 * each commit is written at once: the file grew by 20 kB a commit.
 *
 * <p>Each second what was written is forced to the disk, so that parts of the file may be used
 * again {@link #RETENTION} after they were freed, and pages are moved out of parts that hold
 * little. Freed parts go only as something is written; so for a while after the last change a
 * number is written that nobody uses.
 */
final class H2Compactor implements AutoCloseable {
  /** To be told to H2; it must be longer than it takes until all is forced to the disk. */
  static final Duration RETENTION = Duration.ofSeconds(5);

  private static final Logger log = LoggerFactory.getLogger(H2Compactor.class);
  private static final Duration INTERVAL = Duration.ofSeconds(1);

  /** Without a change of somebody else, until there is nothing left to give back. */
  private static final int LAST_INTERVALS = 20;

  /** Percent of a part of the file that is in use; parts with less are emptied. */
  private static final int LEAST_FILL_RATE = 50;

  private static final int MOST_BYTES_MOVED = 4 * 1024 * 1024;

  private final Jdbi jdbi;
  private final PeriodicWork work;
  private long lastVersion = -1;
  private int idleIntervals;

  H2Compactor(Jdbi jdbi) {
    this.jdbi = jdbi;
    this.work = new PeriodicWork("h2-compactor", INTERVAL, this::compact);
  }

  private void compact() {
    try {
      jdbi.useHandle(this::compact);
    } catch (SQLException | MVStoreException e) {
      log.warn("The database's file could not be compacted; it is tried again.", e);
    }
  }

  private void compact(Handle h) throws SQLException {
    MVStore file = file(h);
    idleIntervals = file.getCurrentVersion() == lastVersion ? idleIntervals + 1 : 0;
    if (idleIntervals < LAST_INTERVALS) {
      h.execute("checkpoint sync");
      file.compact(LEAST_FILL_RATE, MOST_BYTES_MOVED);
      if (idleIntervals > 0) {
        file.setStoreVersion(1 - file.getStoreVersion());
        file.commit();
      }
      lastVersion = file.getCurrentVersion(); // this is no change of somebody else
    }
  }

  private static MVStore file(Handle h) throws SQLException {
    SessionLocal session =
        (SessionLocal) h.getConnection().unwrap(JdbcConnection.class).getSession();
    return session.getDatabase().getStore().getMvStore();
  }

  @Override
  public void close() {
    work.close();
  }
}
