package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Objects;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Fleet;
import org.toqa.web.Doors;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;

/** The button on every page that pauses all robots, and the one that lets them go on. */
public final class FleetServlet extends PageServlet {
  private static final Pattern PLAIN = Pattern.compile("/[A-Za-z0-9._/-]*");

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services().fleet();
    String user = Caller.of(request).name();
    FleetAnswers.await(
        Doors.lastSegment(request).equals("pause") ? fleet.pauseAll(user) : fleet.resumeAll(user));
    String back = request.getParameter("back");
    goTo(request, response, isOwnPage(back) ? Objects.requireNonNull(back) : "/map");
  }

  /** An address that leads elsewhere is not followed. */
  private static boolean isOwnPage(@Nullable String path) {
    return path != null
        && PLAIN.matcher(path).matches()
        && Doors.at(path).flatMap(place -> place.door("GET")).isPresent();
  }
}
