package org.toqa.notices;

import java.net.URI;
import java.time.Instant;
import java.util.Set;

/**
 * An address of a program that is told of notices by HTTP.
 *
 * @param secret by which what is sent there is signed
 * @param kinds of which it is told
 * @param enabled whether it is told at all
 * @param createdBy a user's name
 */
public record Webhook(
    long id,
    URI url,
    WebhookSecret secret,
    Set<NoticeKind> kinds,
    boolean enabled,
    Instant createdAt,
    String createdBy) {

  /** Characters. */
  public static final int LONGEST_URL = 500;

  /** Of a site. */
  public static final int MOST = 20;

  public Webhook {
    kinds = Set.copyOf(kinds);
  }

  boolean wants(Condition condition) {
    return enabled && kinds.contains(condition.kind());
  }
}
