package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.RobotState;

/** The live map; its scripts draw it from the API. */
public final class MapServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute("floors", services().fleet().floors());
    request.setAttribute("floorViews", services().fleet().snapshots().latest().floors());
    request.setAttribute("robotStates", RobotState.values());
    show(request, response, "map");
  }
}
