package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Objects;
import org.toqa.accounts.Session.Origin;

/** Where requests come from. */
public final class RequestOrigin {
  private static final int MAX_USER_AGENT_LENGTH = 200;

  private RequestOrigin() {}

  public static Origin of(HttpServletRequest request) {
    String agent =
        Objects.requireNonNullElse(request.getHeader("User-Agent"), "")
            .replaceAll("[^ -~]", "")
            .strip();
    return new Origin(
        request.getRemoteAddr(),
        agent.substring(0, Math.min(agent.length(), MAX_USER_AGENT_LENGTH)));
  }
}
