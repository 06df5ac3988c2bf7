package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import java.util.UUID;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** The header by which a caller says that an order is one that may have come before. */
final class IdempotencyKey {
  private static final String HEADER = "Idempotency-Key";

  private IdempotencyKey() {}

  /** Who sends none asks for something new each time. */
  static UUID of(HttpServletRequest request) {
    String given = request.getHeader(HEADER);
    if (given == null) {
      return UUID.randomUUID();
    }
    if (!given.matches("[!-~]{1,128}")) {
      throw Problem.of(400, Texts.of(request).get("problem.idempotencyKey")).exception();
    }
    return IdempotentSubmitter.idempotencyKey(Caller.of(request).account(), "header " + given);
  }
}
