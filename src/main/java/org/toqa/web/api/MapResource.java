package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import org.toqa.grid.FloorMap;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;

/** A floor with its places, as it is or as it was. */
public final class MapResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    Instant at = new InputRules(Texts.of(request), errors).moment("at", request.getParameter("at"));
    throwIfAny(errors);
    Json.send(
        request, response, 200, MapJson.of(at == null ? floor(request) : floorThen(request, at)));
  }

  /** The floor may be gone by now. */
  private static FloorMap floorThen(HttpServletRequest request, Instant at) {
    String wanted = request.getParameter("floor");
    String name = wanted == null ? floor(request).name() : wanted;
    return services(request)
        .fleet()
        .floorEditing()
        .mapAt(name, at)
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noMapThen", name)).exception());
  }
}
