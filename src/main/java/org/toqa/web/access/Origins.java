package org.toqa.web.access;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Objects;
import org.toqa.store.Session.Origin;

/** Where requests come from. */
public final class Origins {
  private static final int LONGEST_AGENT = 200;

  private Origins() {}

  public static Origin of(HttpServletRequest request) {
    String agent =
        Objects.requireNonNullElse(request.getHeader("User-Agent"), "")
            .replaceAll("[^ -~]", "")
            .strip();
    return new Origin(
        request.getRemoteAddr(), agent.substring(0, Math.min(agent.length(), LONGEST_AGENT)));
  }
}
