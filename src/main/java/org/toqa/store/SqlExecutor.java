package org.toqa.store;

import java.util.function.Function;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.JdbiException;
import org.jdbi.v3.core.transaction.TransactionIsolationLevel;
import org.toqa.persistence.StoreException;

/** The border to the database: what fails behind it comes out as a {@link StoreException}. */
final class SqlExecutor {
  private final Jdbi jdbi;

  SqlExecutor(Jdbi jdbi) {
    this.jdbi = jdbi;
  }

  <T> T withHandle(Function<Handle, T> work) {
    try {
      return jdbi.withHandle(work::apply);
    } catch (JdbiException e) {
      throw storeException(e);
    }
  }

  <T> T inTransaction(Function<Handle, T> work) {
    try {
      return jdbi.inTransaction(work::apply);
    } catch (JdbiException e) {
      throw storeException(e);
    }
  }

  /**
   * All that the work does on this thread by this or another handle of the same database. It sees
   * what others have committed meanwhile: where it waited for a row of an earlier try, it finds
   * what that has stored.
   */
  void inOneTransaction(Runnable work) {
    try {
      jdbi.useTransaction(TransactionIsolationLevel.READ_COMMITTED, h -> work.run());
    } catch (JdbiException e) {
      throw storeException(e);
    }
  }

  private static StoreException storeException(JdbiException e) {
    Throwable cause = e.getCause() == null ? e : e.getCause();
    return new StoreException(SqlFailures.kind(e), String.valueOf(cause.getMessage()), e);
  }
}
