package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.web.Sites;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;

/**
 * How the server is set: what its configuration says, to be read, and what may be changed while it
 * runs. Managers of other sites than the first one learn nothing of the whole server.
 */
public final class SettingsPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addAttributes(request);
    show(request, response, "settings");
  }

  private static void addAttributes(HttpServletRequest request) {
    Sites sites = Sites.of(request.getServletContext());
    FleetSnapshot fleet = services(request).fleet().snapshots().latest();
    request.setAttribute("floorViews", fleet.floors());
    request.setAttribute("allocators", fleet.allocators());
    if (services(request).site().isFirst() && Caller.of(request).site().isFirst()) {
      request.setAttribute("settings", sites.settings());
      request.setAttribute("logLevels", Sites.LOG_LEVELS);
      request.setAttribute("logLevel", sites.logLevel());
    }
  }

  public static void changeLogLevel(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    String level = request.getParameter("logLevel");
    if (level == null || !Sites.LOG_LEVELS.contains(level)) {
      FieldErrors errors = new FieldErrors();
      errors.add("logLevel", Texts.of(request).get("error.logLevel"));
      addAttributes(request);
      showAgain(request, response, "settings", errors);
      return;
    }
    Sites.of(request.getServletContext()).changeLogLevel(level, Caller.of(request).name());
    redirect(request, response, "/settings?done=changed");
  }
}
