package org.toqa.web.live;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Objects;
import java.util.Optional;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.api.ApiHandler;
import org.toqa.web.api.Problem;

/** Live events: the fleet's snapshots as a stream. */
public final class EventsResource extends ApiHandler {
  /** After which a stream may have ended. */
  private static final String RETRY_SECONDS = "10";

  public static void stream(HttpServletRequest request, HttpServletResponse response) {
    if (request.getMethod().equals("HEAD")) {
      setHeaders(response);
      return;
    }
    boolean changesOnly = isWanted(request, "changes");
    boolean withNotices = isWanted(request, "notices");
    String floor = wantedFloorName(request);
    StreamPlaces places = new StreamPlaces();
    Optional<StreamPlaces.Refusal> refusal =
        places.take(
            services(request).concurrency(),
            Caller.of(request).uniqueName(),
            request.getRemoteAddr());
    if (refusal.isPresent()) {
      response.setHeader("Retry-After", RETRY_SECONDS);
      throw Problem.of(
              429, Texts.of(request).get(refusal.get().key(), refusal.get().max(), RETRY_SECONDS))
          .exception();
    }
    setHeaders(response);
    AsyncContext async = request.startAsync();
    async.setTimeout(0);
    EventStreams.of(request.getServletContext())
        .start(
            async,
            Sites.of(request.getServletContext()),
            services(request),
            Caller.of(request),
            Texts.of(request).locale(),
            changesOnly,
            withNotices,
            floor,
            places,
            request.getHeader("Last-Event-ID"));
  }

  private static boolean isWanted(HttpServletRequest request, String flag) {
    return switch (Objects.requireNonNullElse(request.getParameter(flag), "false")) {
      case "true" -> true;
      case "false" -> false;
      default ->
          throw Problem.of(400, Texts.of(request).get("problem.queryFlag", flag)).exception();
    };
  }

  private static void setHeaders(HttpServletResponse response) {
    response.setContentType("text/event-stream");
    response.setCharacterEncoding("UTF-8");
    response.setHeader("Cache-Control", "no-store, no-transform");
    response.setHeader("X-Accel-Buffering", "no");
  }
}
