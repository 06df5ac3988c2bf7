package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Map;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskPreview;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;
import org.toqa.web.input.TaskOrderReader;

/** What would become of a task; nothing is stored. */
public final class TaskPreviewResource extends ApiHandler {
  public static void preview(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    TaskOrder order = readBody(request, TaskOrderReader::read);
    TaskPreview preview =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).fleet().preview(order, Caller.of(request).name())));
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
