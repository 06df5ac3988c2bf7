package org.toqa.store;

import java.util.function.Function;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.JdbiException;
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

  private static StoreException storeException(JdbiException e) {
    Throwable cause = e.getCause() == null ? e : e.getCause();
    return new StoreException(SqlFailures.kind(e), String.valueOf(cause.getMessage()), e);
  }
}
