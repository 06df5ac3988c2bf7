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

/** Tells everybody whether the first site's fleet goes on and what ails it, but no names. */
public final class HealthResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services(request).fleet();
    List<Sentence> failures = fleet.failures();
    Set<Sentence> alerts = new LinkedHashSet<>(failures);
    alerts.addAll(fleet.snapshots().latest().alerts());
    alerts.removeAll(fleet.advice());
    if (alerts.isEmpty()) {
      Json.send(request, response, 200, Map.of("status", "UP"));
    } else {
      String status = failures.isEmpty() ? "DEGRADED" : "DOWN";
      List<Sentence> told = alerts.stream().map(Sentence::withoutNames).distinct().toList();
      Json.send(request, response, 503, Map.of("status", status, "alerts", told));
    }
  }
}
