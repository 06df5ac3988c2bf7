package org.toqa.store;

import com.zaxxer.hikari.SQLExceptionOverride;
import java.sql.SQLException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.h2.api.ErrorCode;

/**
 * Finds out that H2 has closed its database by itself, as it does where it cannot write the file.
 * While connections to the closed one are left, it cannot be opened again in the same process.
 */
final class ClosedH2 implements SQLExceptionOverride {
  private final CompletableFuture<Void> closed = new CompletableFuture<>();

  @java.lang.Override // the pool's own word is another Override
  public Override adjudicate(SQLException failure) {
    if (failure.getErrorCode() == ErrorCode.DATABASE_IS_CLOSED) {
      closed.complete(null);
    }
    return Override.CONTINUE_EVICT;
  }

  boolean isFound() {
    return closed.isDone();
  }

  CompletionStage<Void> whenFound() {
    return closed.minimalCompletionStage();
  }
}
