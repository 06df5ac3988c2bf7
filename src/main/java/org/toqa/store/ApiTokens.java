package org.toqa.store;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Base64;
import java.util.HexFormat;
import java.util.Optional;
import org.jdbi.v3.core.Jdbi;

/**
 * Bearer tokens of the API: 256 random bits that are known to their holder alone. The table has
 * only their SHA-256, which needs no salt or stretching for a secret of that size.
 */
public final class ApiTokens {
  private static final int RANDOM_BYTES = 32;

  private final Sql sql;
  private final InstantSource clock;
  private final Duration life;
  private final LastKnown<String, Account> known = new LastKnown<>();
  private final SecureRandom random = new SecureRandom();

  /**
   * @param life how long a token is good
   */
  public ApiTokens(Jdbi jdbi, InstantSource clock, Duration life) {
    this.sql = new Sql(jdbi);
    this.clock = clock;
    this.life = life;
  }

  /** A new token for that user; expired ones of all users are removed on the way. */
  public String issue(long userId) {
    byte[] secret = new byte[RANDOM_BYTES];
    random.nextBytes(secret);
    String token = Base64.getUrlEncoder().withoutPadding().encodeToString(secret);
    Instant now = clock.instant();
    sql.inTransaction(
        handle -> {
          handle.execute("delete from api_tokens where expires_at <= ?", Sql.utc(now));
          handle.execute(
              """
              insert into api_tokens (user_id, token_hash, created_at, expires_at)
              values (?, ?, ?, ?)
              """,
              userId,
              hash(token),
              Sql.utc(now),
              Sql.utc(now.plus(life)));
          return token;
        });
    return token;
  }

  /**
   * The user who holds the token, while it is good; what was said last, while the database is away.
   */
  public Optional<Account> owner(String token) {
    String hash = hash(token);
    return known.ask(hash, () -> stored(hash));
  }

  private Optional<Account> stored(String hash) {
    return sql.in(
        handle ->
            handle
                .createQuery(
                    "select "
                        + Accounts.columns()
                        + """
                           from users u join api_tokens t on t.user_id = u.id
                          where t.token_hash = :hash and t.expires_at > :now
                          """)
                .bind("hash", hash)
                .bind("now", Sql.utc(clock.instant()))
                .map(Accounts::account)
                .findOne());
  }

  private static String hash(String token) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(token.getBytes(StandardCharsets.UTF_8));
      return HexFormat.of().formatHex(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError("Every Java has SHA-256.", e);
    }
  }
}
