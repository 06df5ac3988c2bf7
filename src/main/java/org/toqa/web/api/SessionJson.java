package org.toqa.web.api;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Scope;
import org.toqa.accounts.Session;

/** A session on the wire. */
record SessionJson(
    long id,
    Session.Kind kind,
    @Nullable String name,
    List<String> scopes,
    String address,
    String agent,
    Instant createdAt,
    Instant seenAt,
    Instant expiresAt) {

  static SessionJson of(Session session) {
    return new SessionJson(
        session.id(),
        session.kind(),
        session.name(),
        session.scopes().stream().sorted().map(Scope::word).toList(),
        session.origin().address(),
        session.origin().agent(),
        session.createdAt(),
        session.seenAt(),
        session.expiresAt());
  }
}
