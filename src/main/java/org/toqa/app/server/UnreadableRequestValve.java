package org.toqa.app.server;

import java.io.IOException;
import java.io.Writer;
import org.apache.catalina.connector.Request;
import org.apache.catalina.connector.Response;
import org.apache.catalina.valves.ErrorReportValve;
import org.jspecify.annotations.Nullable;
import org.toqa.web.access.SecurityHeadersFilter;

/**
 * Answers what never reaches the web application, such as an address that is too long: in one
 * sentence, without what the container would tell of itself.
 */
final class UnreadableRequestValve extends ErrorReportValve {
  private static final String UNREADABLE =
      "This request cannot be read: its address or its headers are too long, its address has what"
          + " none may have, such as %2F or %00, or it is not HTTP.\n";

  private static final String NOT_NOW = "The server cannot answer now. Try again in a minute.\n";

  @Override
  protected void report(Request request, Response response, @Nullable Throwable throwable) {
    if (response.getStatus() < 400
        || response.getContentWritten() > 0
        || !response.setErrorReported()) {
      return;
    }
    response.setContentType("text/plain");
    response.setCharacterEncoding("UTF-8");
    SecurityHeadersFilter.setHeaders(response, request.isSecure());
    response.setHeader("Cache-Control", "no-store");
    try {
      Writer writer = response.getReporter();
      if (writer != null) {
        writer.write(response.getStatus() < 500 ? UNREADABLE : NOT_NOW);
        response.finishResponse();
      }
    } catch (IOException e) {
      container.getLogger().debug("Nobody waits for the answer any more.", e);
    }
  }
}
