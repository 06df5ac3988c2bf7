package org.toqa.store;

import java.sql.SQLException;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.h2.engine.SessionLocal;
import org.h2.jdbc.JdbcConnection;
import org.h2.mvstore.MVStore;
import org.h2.mvstore.MVStore.TxCounter;
import org.h2.mvstore.MVStoreException;
import org.h2.mvstore.RandomAccessStore;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.JdbiException;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Gives back what the file of an H2 database does not need any more. H2 appends all that changes,
 * and has a thread of its own for what is left behind, but not with {@code WRITE_DELAY=0}, where
 * each commit is written at once: the file grew by 20 kB a commit.
 *
 * <p>Each second, and as soon as a good deal was written, that is forced to the disk. What a
 * computer that loses its power finds there stays as it is until the next time: the version that
 * was forced counts as used, so that parts of the file which it needs are not used again, and
 * others are at once. Then pages are moved out of parts that hold little, and, where a good deal of
 * the file is free, parts from its end to its front. Freed parts go only as something is written;
 * so for a while after the last change a number is written that nobody uses.
 */
final class H2Compactor implements AutoCloseable {
  /** To be told to H2, for the time until something is forced to the disk. */
  static final Duration RETENTION = Duration.ofSeconds(5);

  private static final Logger log = LoggerFactory.getLogger(H2Compactor.class);

  /** From one look at the file to the next. */
  static final Duration INTERVAL = Duration.ofMillis(100);

  /** From one turn to the next, where little is written. */
  private static final int LOOKS_PER_TURN = 10;

  /** Without a change of somebody else, until there is nothing left to give back. */
  private static final int LAST_TURNS = 20;

  /** Percent of the parts of the file that is in use; below it those with little are emptied. */
  private static final int LEAST_FILL_RATE = 70;

  /** Of pages that are moved at a time. */
  private static final int MOST_PAGE_BYTES = 256 * 1024;

  /**
   * For so much that was written pages are moved once. To free as much as was written, where a
   * share u of what the parts hold is in use, u / (1 - u) times as much must be moved: twice as
   * much keeps u near two thirds.
   */
  private static final long BYTES_PER_PAGE_MOVE = MOST_PAGE_BYTES / 2;

  /** In one turn; commits come between them. */
  private static final int MOST_PAGE_MOVES = 8;

  /** A file that is smaller is left as it is. */
  private static final long LEAST_SIZE = 2 * 1024 * 1024;

  /** Percent of the file that its parts take; below it they are moved to the front. */
  private static final int LEAST_FILE_FILL_RATE = 80;

  /** Of parts that are moved at a time: while they are on their way, the file grows by as much. */
  private static final long MOST_PART_BYTES = 256 * 1024;

  /** In one turn. */
  private static final int MOST_PART_MOVES = 3;

  /** How H2 calls what was written to the file since it was opened. */
  private static final String WRITTEN_BYTES = "info.FILE_WRITE_BYTES";

  private final Jdbi jdbi;

  /** Null: nothing was forced to the disk yet. */
  private @Nullable ForcedVersion forced;

  private long lastVersion = -1;

  private int idleTurns;

  /** Since the last turn. */
  private int looks;

  /** In all, when the last turn had ended: what it wrote itself asks for no other one. */
  private long lastWritten;

  /** Whether the last turn failed, which is said once. */
  private boolean isFailing;

  /** A version of all data that is on the disk, and counts as used. */
  private record ForcedVersion(MVStore store, TxCounter version) {
    void giveUp() {
      if (!store.isClosed()) {
        store.deregisterVersionUsage(version);
      }
    }
  }

  H2Compactor(Jdbi jdbi) {
    this.jdbi = jdbi;
  }

  /** Has a turn if it is time; to be called again and again. */
  void compact() {
    try {
      jdbi.useHandle(h -> compact(h, file(h)));
      isFailing = false;
    } catch (SQLException | MVStoreException | JdbiException e) {
      if (!isFailing) {
        log.warn(
            "The database's file could not be compacted; it is tried again: {}",
            Database.rootCauseMessage(e));
      }
      isFailing = true;
    }
  }

  private void compact(Handle h, MVStore file) {
    long moves = (writtenBytes(file) - lastWritten) / BYTES_PER_PAGE_MOVE;
    looks++;
    if (moves > 0 || looks >= LOOKS_PER_TURN) {
      looks = 0;
      try {
        takeTurn(h, file, Math.clamp(moves, 1, MOST_PAGE_MOVES));
      } finally { // else one that fails would be tried again at each look
        lastWritten = writtenBytes(file);
      }
    }
  }

  private static long writtenBytes(MVStore file) {
    AtomicLong bytes = new AtomicLong();
    file.getFileStore()
        .populateInfo(
            (name, value) -> {
              if (name.equals(WRITTEN_BYTES)) {
                bytes.set(Long.parseLong(value));
              }
            });
    return bytes.get();
  }

  private void takeTurn(Handle h, MVStore file, int moves) {
    idleTurns = file.getCurrentVersion() == lastVersion ? idleTurns + 1 : 0;
    if (idleTurns < LAST_TURNS) {
      force(h, file);
      for (int i = 0; i < moves; i++) {
        file.compact(LEAST_FILL_RATE, MOST_PAGE_BYTES);
      }
      if (idleTurns > 0) {
        file.setStoreVersion(1 - file.getStoreVersion());
        file.commit();
      }
      moveToFront(file);
      lastVersion = file.getCurrentVersion(); // this is no change of somebody else
    }
  }

  private void force(Handle h, MVStore store) {
    ForcedVersion version = new ForcedVersion(store, store.registerVersionUsage());
    try {
      h.execute("checkpoint sync");
    } catch (RuntimeException e) {
      version.giveUp();
      throw e;
    }
    giveUpForced();
    forced = version;
    store.setRetentionTime(0); // from now on the forced version says what is kept
  }

  private void giveUpForced() {
    if (forced != null) {
      forced.giveUp();
      forced = null;
    }
  }

  private static void moveToFront(MVStore store) {
    if (store.getFileStore() instanceof RandomAccessStore parts) {
      for (int i = 0;
          i < MOST_PART_MOVES
              && parts.size() > LEAST_SIZE
              && parts.getFillRate() < LEAST_FILE_FILL_RATE;
          i++) {
        parts.compactMoveChunks(LEAST_FILE_FILL_RATE, MOST_PART_BYTES, store);
      }
    }
  }

  private static MVStore file(Handle h) throws SQLException {
    SessionLocal session =
        (SessionLocal) h.getConnection().unwrap(JdbcConnection.class).getSession();
    return session.getDatabase().getStore().getMvStore();
  }

  @Override
  public void close() {
    giveUpForced();
  }
}
