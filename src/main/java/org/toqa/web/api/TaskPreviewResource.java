package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Map;
import org.toqa.fleet.TaskPreview;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;
import org.toqa.web.input.OrderedTask;

/** What would become of a task; nothing is stored. */
public final class TaskPreviewResource extends ApiHandler {
  public static void preview(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    OrderedTask ordered = readBody(request, TemplatesResource.usable(request)::read);
    TaskPreview preview =
        acceptedValue(
            request,
            ordered.atEntered(
                FleetAnswers.await(
                    services(request)
                        .fleet()
                        .preview(ordered.order(), Caller.of(request).name()))));
    Json.send(
        request,
        response,
        200,
        Map.of(
            "robots", preview.robots(),
            "chosen", preview.chosen(),
            "reason", preview.reason(),
            "metres", preview.metres(),
            "way", preview.path().stream().map(p -> Map.of("x", p.x(), "y", p.y())).toList()));
  }
}
