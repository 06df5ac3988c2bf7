package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.toqa.wording.Sentence;

/** Says that the server answers, and what ails the whole fleet. */
public final class HealthResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    List<Sentence> alerts = services(request).fleet().snapshots().latest().alerts();
    if (alerts.isEmpty()) {
      Json.send(request, response, 200, Map.of("status", "UP"));
    } else {
      Json.send(request, response, 503, Map.of("status", "DEGRADED", "alerts", alerts));
    }
  }
}
