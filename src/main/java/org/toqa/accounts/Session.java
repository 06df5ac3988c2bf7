package org.toqa.accounts;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * A login that lasts.
 *
 * @param name what its owner calls a token that he made by hand; null for every other session
 * @param scopes what it may do of what its user may; of a login, all
 * @param seenAt when it was last used, within a minute
 */
public record Session(
    long id,
    long userId,
    Kind kind,
    @Nullable String name,
    Set<Scope> scopes,
    Origin origin,
    Instant createdAt,
    Instant seenAt,
    Instant expiresAt) {

  /** How it began, and what ends it. */
  public enum Kind {
    /** Somebody logged in on a page. It ends after a shift without use. */
    BROWSER(Carrier.COOKIE, Duration.ofHours(12)),
    /** A program logged in by a name and a password. It ends after an hour without use. */
    API(Carrier.BEARER, Duration.ofHours(1)),
    /** Somebody made it for a program. It ends at a time that is set when it is made. */
    TOKEN(Carrier.BEARER, null);

    private final Carrier carrier;
    private final @Nullable Duration idleLimit;

    Kind(Carrier carrier, @Nullable Duration idleLimit) {
      this.carrier = carrier;
      this.idleLimit = idleLimit;
    }

    public Carrier carrier() {
      return carrier;
    }

    /** How long it lasts without use; empty: use does not matter. */
    public Optional<Duration> idleLimit() {
      return Optional.ofNullable(idleLimit);
    }
  }

  /** What shows the secret. */
  public enum Carrier {
    COOKIE,
    BEARER
  }

  /** The same after its use. */
  public Session withUse(Instant now, Instant end) {
    return new Session(id, userId, kind, name, scopes, origin, createdAt, now, end);
  }

  /** Whether tokens may be made in it: somebody sits there, who is asked for his password. */
  public boolean mayCreateTokens() {
    return kind == Kind.BROWSER;
  }

  /**
   * What began it.
   *
   * @param agent the browser or program, as it calls itself
   */
  public record Origin(String address, String agent) {}
}
