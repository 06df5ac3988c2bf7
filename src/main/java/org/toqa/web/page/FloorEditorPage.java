package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.grid.FloorLimits;
import org.toqa.web.RequestPath;

/** Where managers draw a floor; its script does the rest. */
public final class FloorEditorPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    String floor = RequestPath.parameter(request, "floor");
    if (services(request).fleet().floors().stream().noneMatch(f -> f.name().equals(floor))) {
      sendNotFound(request, response, "floors.gone");
      return;
    }
    request.setAttribute("floor", floor);
    request.setAttribute("segment", RequestPath.segment(floor));
    request.setAttribute("slowest", FloorLimits.SLOWEST);
    request.setAttribute("fastest", FloorLimits.FASTEST);
    request.setAttribute("longestName", FloorLimits.LONGEST_NAME);
    show(request, response, "floor-editor");
  }
}
