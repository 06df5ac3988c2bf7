package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.RobotState;

/** The live map; its scripts draw it from the API. */
public final class MapPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute("floorViews", services(request).fleet().snapshots().latest().floors());
    request.setAttribute("allocators", services(request).fleet().snapshots().latest().allocators());
    request.setAttribute(
        "cameras",
        services(request).cameras().all().stream()
            .filter(camera -> camera.floor() != null)
            .toList());
    request.setAttribute("robotStates", RobotState.values());
    show(request, response, "map");
  }
}
