package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.LoadView;
import org.toqa.web.Loads;
import org.toqa.web.input.FieldErrors;

/** All loads, and where each is. */
public final class LoadsPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    request.setAttribute(
        "loads",
        wantedFloor(request, errors).filter(new Loads(services(request)).all(), LoadView::floor));
    showList(request, response, "loads", errors);
  }
}
