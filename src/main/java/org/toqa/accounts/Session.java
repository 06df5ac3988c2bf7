package org.toqa.accounts;

import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A login that lasts.
 *
 * @param name what its owner calls a token that he made by hand; null for every other session
 * @param seenAt when it was last used, within a minute
 */
public record Session(
    long id,
    long userId,
    Kind kind,
    @Nullable String name,
    Origin origin,
    Instant createdAt,
    Instant seenAt,
    Instant expiresAt) {

  /** What shows the secret. */
  public enum Kind {
    /** In a cookie. It ends when it was not used for a while. */
    BROWSER,
    /** As a bearer token. It ends at a time that is set when it is made. */
    TOKEN
  }

  /**
   * What began it.
   *
   * @param agent the browser or program, as it calls itself
   */
  public record Origin(String address, String agent) {}
}
