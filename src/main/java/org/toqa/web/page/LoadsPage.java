package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.LoadView;
import org.toqa.web.Loads;

/** All loads, and where each is. */
public final class LoadsPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute(
        "loads", wantedFloor(request).filter(new Loads(services(request)).all(), LoadView::floor));
    show(request, response, "loads");
  }
}
