package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.Fleet;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;

/** The button on every page that pauses all robots, and the one that lets them go on. */
public final class FleetServlet extends PageServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services().fleet();
    String user = Caller.of(request).name();
    FleetAnswers.await(
        RequestPath.lastSegment(request).equals("pause") ? fleet.pauseAll(user) : fleet.resumeAll(user));
    redirect(request, response, ReturnAddress.parse(request, request.getParameter("back")).orElse("/map"));
  }
}
