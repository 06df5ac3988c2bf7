package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.grid.FloorMap;
import org.toqa.web.FleetAnswers;
import org.toqa.web.FloorSummary;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FloorOrder;
import org.toqa.web.input.FloorOrderReader;
import org.toqa.web.input.JsonFields;

/** All floors, and new ones. */
public final class FloorsResource extends ApiHandler {
  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, FloorSummary.all(services(request)));
  }

  /** With a drawing, or empty and of some size. */
  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorOrder order = readLargeBody(request, FloorsResource::readOrder);
    FloorMap added =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request)
                    .fleet()
                    .floorEditing()
                    .addFloor(order.name(), order.drawing(), Caller.of(request).name())));
    response.setHeader(
        "Location",
        request.getContextPath() + "/api/v1/floors/" + RequestPath.segment(added.name()));
    Json.send(
        request,
        response,
        HttpServletResponse.SC_CREATED,
        FloorSummary.of(added, services(request)));
  }

  private static FloorOrder readOrder(JsonFields fields) {
    if (!fields.has("drawing")) {
      return FloorOrderReader.readEmpty(fields);
    }
    FloorOrder order =
        new FloorOrder(
            FloorOrderReader.readName(fields), DrawingReader.read(fields.object("drawing")));
    fields.refuseUnknown();
    return order;
  }
}
