package org.toqa.persistence;

import org.jspecify.annotations.Nullable;

/**
 * The store did not answer, or refused. The change that was asked for has happened as a whole or
 * not at all, and nobody knows which; what was refused has not happened.
 */
public final class StoreException extends RuntimeException {
  private static final long serialVersionUID = 1;

  /** What asking again may bring. */
  public enum Kind {
    /** The store is away, or in trouble of its own: the same may succeed later. */
    UNAVAILABLE,
    /** Somebody else has stored it meanwhile, or what it needs: who asks again finds that. */
    OVERTAKEN,
    /** The store takes everything but this, now and later, such as a text that is too long. */
    REFUSED,
    /** Who asks for it may not log in any more, or is no user any more. */
    UNKNOWN_USER,
    /** It took longer than anybody may ask for; the same takes as long again. */
    TOO_SLOW
  }

  private final Kind kind;

  /** One of {@link Kind#UNAVAILABLE}. */
  public StoreException(String message, @Nullable Throwable cause) {
    this(Kind.UNAVAILABLE, message, cause);
  }

  public StoreException(Kind kind, String message, @Nullable Throwable cause) {
    super(message, cause);
    this.kind = kind;
  }

  /** What a change failed by: a fault of this program in it is one that comes again each time. */
  public static StoreException of(RuntimeException failure) {
    return failure instanceof StoreException known
        ? known
        : new StoreException(Kind.REFUSED, String.valueOf(failure), failure);
  }

  public Kind kind() {
    return kind;
  }

  /** Whether the same can never be stored. */
  public boolean isRefusal() {
    return kind == Kind.REFUSED || kind == Kind.UNKNOWN_USER;
  }
}
