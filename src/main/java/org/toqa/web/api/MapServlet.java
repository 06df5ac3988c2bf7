package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.stream.Collectors;
import org.toqa.grid.FloorMap;
import org.toqa.web.Texts;

/** A floor with its places. */
public final class MapServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    List<FloorMap> floors = services().fleet().floors();
    String wanted = request.getParameter("floor");
    FloorMap floor =
        floors.stream()
            .filter(f -> wanted == null || f.name().equals(wanted))
            .findFirst()
            .orElseThrow(() -> noSuchFloor(request, floors));
    Json.send(response, 200, MapJson.of(floor));
  }

  private static Problem.Raised noSuchFloor(HttpServletRequest request, List<FloorMap> floors) {
    String names = floors.stream().map(FloorMap::name).collect(Collectors.joining(", "));
    return Problem.of(404, Texts.of(request).get("problem.noSuchFloor", names)).raised();
  }
}
