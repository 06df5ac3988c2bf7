package org.toqa.persistence;

import org.jspecify.annotations.Nullable;

/**
 * The store did not answer, or refused. The change that was asked for has happened as a whole or
 * not at all, and nobody knows which.
 */
public final class StoreException extends RuntimeException {
  private static final long serialVersionUID = 1;

  public StoreException(String message, @Nullable Throwable cause) {
    super(message, cause);
  }
}
