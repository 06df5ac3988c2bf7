package org.toqa.app.server;

import java.io.IOException;
import java.io.Writer;
import org.apache.catalina.connector.Request;
import org.apache.catalina.connector.Response;
import org.apache.catalina.valves.ErrorReportValve;
import org.jspecify.annotations.Nullable;

/**
 * Answers what never reaches the web application, such as an address that is too long: in one
 * sentence, without what the container would tell of itself.
 */
final class UnreadableRequestValve extends ErrorReportValve {
  private static final String SENTENCE =
      "This request cannot be read: its address or its headers are too long, or it is not HTTP.\n";

  @Override
  protected void report(Request request, Response response, @Nullable Throwable throwable) {
    if (response.getStatus() < 400
        || response.getContentWritten() > 0
        || !response.setErrorReported()) {
      return;
    }
    response.setContentType("text/plain");
    response.setCharacterEncoding("UTF-8");
    response.setHeader("Content-Security-Policy", "default-src 'self'; frame-ancestors 'none'");
    response.setHeader("X-Content-Type-Options", "nosniff");
    response.setHeader("Cache-Control", "no-store");
    try {
      Writer writer = response.getReporter();
      if (writer != null) {
        writer.write(SENTENCE);
        response.finishResponse();
      }
    } catch (IOException e) {
      container.getLogger().debug("Nobody waits for the answer any more.", e);
    }
  }
}
