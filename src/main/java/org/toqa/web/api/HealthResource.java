package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.toqa.fleet.Fleet;
import org.toqa.wording.Sentence;

/** Says whether the fleet goes on, and what ails all of it. */
public final class HealthResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services(request).fleet();
    List<Sentence> failures = fleet.failures();
    Set<Sentence> alerts = new LinkedHashSet<>(failures);
    alerts.addAll(fleet.snapshots().latest().alerts());
    if (alerts.isEmpty()) {
      Json.send(request, response, 200, Map.of("status", "UP"));
    } else {
      String status = failures.isEmpty() ? "DEGRADED" : "DOWN";
      Json.send(request, response, 503, Map.of("status", status, "alerts", alerts));
    }
  }
}
