package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.SiteSummary;
import org.toqa.web.Sites;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.JsonFields;
import org.toqa.web.input.SiteOrder;

/** All sites, for administrators, who make some and delete some. */
public final class SitesResource extends ApiHandler {
  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, sites(request).all());
  }

  private static Sites sites(HttpServletRequest request) {
    return Sites.of(request.getServletContext());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    SiteOrder order = SiteOrder.read(fields);
    fields.refuseUnknown();
    throwIfAny(errors);
    SiteSummary added = acceptedValue(request, order.place(request, Caller.of(request).name()));
    response.setHeader(
        "Location",
        request.getContextPath() + "/api/v1/sites/" + RequestPath.segment(added.name()));
    Json.send(request, response, HttpServletResponse.SC_CREATED, added);
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    acceptedValue(
        request,
        FleetAnswers.await(
            sites(request)
                .remove(RequestPath.parameter(request, "site"), Caller.of(request).name())));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }
}
