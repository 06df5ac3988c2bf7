package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.regex.Pattern;
import org.toqa.fleet.Fleet;
import org.toqa.web.Doors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;

/** The button on every page that pauses all robots, and the one that lets them go on. */
public final class FleetServlet extends PageServlet {
  /** A page of ours: an address that could lead elsewhere is not followed. */
  private static final Pattern OWN_PAGE = Pattern.compile("/[a-z][A-Za-z0-9._/-]*");

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services().fleet();
    String user = Caller.of(request).name();
    FleetAnswers.await(
        Doors.lastSegment(request).equals("pause") ? fleet.pauseAll(user) : fleet.resumeAll(user));
    String back = request.getParameter("back");
    goTo(request, response, back != null && OWN_PAGE.matcher(back).matches() ? back : "/map");
  }
}
